// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"
#include "core/haptics/boundary/pose_boundary.h"

namespace burin {

/// The part's boundary for a tool that keeps its current axis, as a field over tip positions; guides use it. Haptic
/// thread.
class PartAtAxis final : public ClearanceField {
public:
    /// @param part outlives the object
    explicit PartAtAxis(PoseBoundary& part) noexcept : part_(&part) {}

    void setAxis(const glm::dvec3& axis) noexcept { axis_ = axis; }
    FieldSample at(const glm::dvec3& tip) const noexcept override {
        const PoseSample sample = part_->at({tip, axis_}, enough);
        return {sample.clearance, sample.gradient, sample.fine};
    }
    double errorBound() const noexcept override { return part_->errorBound(); }
    double spacing() const noexcept override { return part_->spacing(); }

private:
    static constexpr double enough = 20.0; ///< mm; no guide captures a hand from farther away
    PoseBoundary* part_;
    glm::dvec3 axis_{0.0, 0.0, 1.0};
};

} // namespace burin
