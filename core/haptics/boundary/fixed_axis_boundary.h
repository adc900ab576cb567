// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"
#include "core/haptics/boundary/pose_boundary.h"

#include <memory>
#include <utility>

namespace burin {

/// A clearance field over tip positions as a boundary: the tool has the axis that the field was made for.
class FixedAxisBoundary final : public PoseBoundary {
public:
    /// @param field outlives the object. @param distance mm between the boundary and the surface where the field is 0
    explicit FixedAxisBoundary(const ClearanceField& field, double distance = 0.0) noexcept
        : field_(&field), distance_(distance) {}
    /// @param field never null
    explicit FixedAxisBoundary(std::shared_ptr<const ClearanceField> field) noexcept
        : owned_(std::move(field)), field_(owned_.get()) {}

    PoseSample at(const ToolPose& pose, double) noexcept override {
        const FieldSample sample = field_->at(pose.tip);
        return {sample.clearance - distance_, sample.gradient, glm::dvec3(0.0), sample.fine};
    }
    double errorBound() const noexcept override { return field_->errorBound(); }
    double spacing() const noexcept override { return field_->spacing(); }
    double overlap() const noexcept override { return 0.0; }
    double reach() const noexcept override { return 0.0; }

private:
    std::shared_ptr<const ClearanceField> owned_;
    const ClearanceField* field_;
    double distance_ = 0.0;
};

} // namespace burin
