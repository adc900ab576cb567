// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/length_unit.h"
#include "ui/workbench/workbench.h"

#include <QObject>
#include <QTimer>
#include <QWidget>

#include <vector>

namespace burin {

/// Turns what controllers hold into what one widget shows. However many changes come at once, the widget is told once;
/// a hidden one, when it is shown or in a turn of the event loop of its own.
class Presenter : public QObject {
    Q_OBJECT
public:
    /// @param sources whose changes matter; they and the workbench outlive the presenter
    Presenter(Workbench& workbench, const std::vector<Controller*>& sources, QObject* parent);

    virtual void setUnit(LengthUnit unit);
    void presentSoon();

    bool eventFilter(QObject* watched, QEvent* event) override;

protected:
    virtual void present() = 0;
    /// What is shown takes long: as long as its widget is hidden, others go first. @param widget outlives the presenter
    void yieldWhileHidden(QWidget& widget);
    LengthUnit unit() const noexcept { return unit_; }

    Workbench& workbench_;

private:
    void presentDue();

    QWidget* widget_ = nullptr; ///< null: never yields
    QTimer turn_;
    LengthUnit unit_ = LengthUnit::millimetre;
    bool due_ = false;
};

} // namespace burin
