// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/field/tool_field.h"

namespace burin {

/// A part in a frame whose z is along a tool's axis. @param turn rotation from the setup frame to that frame
/// (frameAlong)
TriangleMesh turnedPart(const MeshDistance& part, const glm::dmat3& turn);

/// The clearance of a tool with a fixed axis in any direction (3+2): a ToolField of the part in a frame whose z is
/// along the axis.
class TurnedField final : public ClearanceField {
public:
    /// @param axis of unit length, setup frame, towards the holder
    /// @param request tool and setup frame as for ToolField::build. Cost and errors: those of ToolField::build.
    static Result<TurnedField> build(const MeshDistance& part, const glm::dvec3& axis, const ToolFieldRequest& request,
                                     Progress& progress);

    FieldSample at(const glm::dvec3& tip) const noexcept override;
    double errorBound() const noexcept override { return field_.errorBound(); }
    double errorBoundAt(const glm::dvec3& tip) const noexcept override { return field_.errorBoundAt(turn_ * tip); }
    double spacing() const noexcept override { return field_.spacing(); }
    std::size_t memoryBytes() const noexcept { return field_.memoryBytes(); }

private:
    TurnedField(const glm::dmat3& turn, ToolField field) noexcept : turn_(turn), field_(std::move(field)) {}

    glm::dmat3 turn_; ///< rotation from the setup frame to the frame whose z is along the axis
    ToolField field_;
};

} // namespace burin
