// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/area_controller.h"

#include "ui/workbench/value_command.h"

#include <utility>

namespace burin {

void AreaController::add(const PlanRegion& region) {
    become(joined(area_, region), tr("painting an area"));
}

void AreaController::erase(const PlanRegion& region) {
    become(without(area_, region), tr("erasing from an area"));
}

void AreaController::clear() {
    become({}, tr("clearing the area"));
}

void AreaController::become(PlanRegion area, const QString& what) {
    if (area == area_) return;
    desk_.undo.push(
        new ValueCommand<PlanRegion>(what, -1, area_, std::move(area), [this](const PlanRegion& now) { apply(now); }));
}

void AreaController::apply(const PlanRegion& area) {
    area_ = area;
    emit changed();
}

void AreaController::load(PlanRegion area) {
    area_ = std::move(area);
    emit changed();
}

} // namespace burin
