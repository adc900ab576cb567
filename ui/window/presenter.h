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

/// Converts the state of controllers into what one widget shows. Simultaneous changes update the widget only once; a
/// hidden one, when it is shown or in a later turn of the event loop.
class Presenter : public QObject {
    Q_OBJECT
public:
    /// @param sources whose changes are followed; they and the workbench outlive the presenter
    Presenter(Workbench& workbench, const std::vector<Controller*>& sources, QObject* parent);

    virtual void setUnit(LengthUnit unit);
    void presentSoon();

    bool eventFilter(QObject* watched, QEvent* event) override;

protected:
    virtual void present() = 0;
    /// Updating takes long: while the widget is hidden, other presenters go first. @param widget outlives the presenter
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
