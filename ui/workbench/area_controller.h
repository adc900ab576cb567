// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/plan_region.h"
#include "ui/workbench/controller.h"

namespace burin {

/// The area that the user painted for the next pass, mm, setup frame. Each change is an entry of the undo stack.
class AreaController final : public Controller {
    Q_OBJECT
public:
    using Controller::Controller;

    const PlanRegion& area() const noexcept { return area_; }
    void add(const PlanRegion& region);
    void erase(const PlanRegion& region);
    void clear();
    void load(PlanRegion area); ///< Called for another project or setup; makes no entry of the undo stack

private:
    void become(PlanRegion area, const QString& what);
    void apply(const PlanRegion& area);

    PlanRegion area_;
};

} // namespace burin
