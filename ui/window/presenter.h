// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/length_unit.h"
#include "ui/workbench/workbench.h"

#include <QObject>

#include <vector>

namespace burin {

/// Turns what controllers hold into what one widget shows. However many changes come at once, the widget is told once.
class Presenter : public QObject {
    Q_OBJECT
public:
    /// @param sources whose changes matter; they and the workbench outlive the presenter
    Presenter(Workbench& workbench, const std::vector<Controller*>& sources, QObject* parent);

    virtual void setUnit(LengthUnit unit);
    void presentSoon();

protected:
    virtual void present() = 0;
    LengthUnit unit() const noexcept { return unit_; }

    Workbench& workbench_;

private:
    LengthUnit unit_ = LengthUnit::millimetre;
    bool due_ = false;
};

} // namespace burin
