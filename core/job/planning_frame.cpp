// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/planning_frame.h"

#include "core/geometry/frame_along.h"
#include "core/geometry/upright.h"

namespace burin {

PlanningFrame::PlanningFrame(const MillingContext& milling, const ClearanceField& field, const glm::dvec3& axis)
    : upright_(axis == uprightAxis), turn_(frameAlong(axis)), setupField_(&field), seenField_(field, turn_) {
    if (upright_) {
        stock_ = milling.setup.stock;
        part_ = milling.partModel->box();
        return;
    }
    stock_ = boxAround(milling.setup.stock, turn_);
    for (const Body& body : milling.partModel->bodies)
        for (const glm::dvec3& vertex : body.mesh.vertices) part_.include(turn_ * vertex);
}

Box PlanningFrame::toSetup(const Box& box) const noexcept {
    return upright_ ? box : boxAround(box, glm::transpose(turn_));
}

FieldSample PlanningFrame::SeenField::at(const glm::dvec3& tip) const noexcept {
    FieldSample sample = field_->at(tip * turn_); // multiplies by the transposed rotation, the inverse
    sample.gradient = turn_ * sample.gradient;
    return sample;
}

} // namespace burin
