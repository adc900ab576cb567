// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geometry/mesh_distance.h"

#include <memory>
#include <vector>

namespace burin {

struct BrickField;

/// Parameters of a tool's configuration-space field.
struct ToolFieldRequest {
    std::vector<RevolvedPiece> tool; ///< flutes, shank, holder; axis +Z
    Box tips;                        ///< range of the tip, mm, setup frame
    double voxel = 0.5;              ///< edge of the workpiece's voxels, mm: the unit of the permitted error
    double maximumAllowance = 1.0;   ///< mm, the field is fine up to this clearance
};

struct FieldSample {
    double clearance = 0.0;   ///< mm, never above the true clearance by more than `errorBoundAt` the tip
    glm::dvec3 gradient{0.0}; ///< of the clearance, about unit length
    bool fine = false;        ///< inside the fine band
};

/// The clearance of a tool, its tip at a point, from what it must not enter. The proxy of the haptic loop moves in it
/// as a point. Implemented by closed formulas in tests, and by ToolField for a part.
class ClearanceField {
public:
    virtual ~ClearanceField() = default;
    /// Any thread; no allocation, no exception.
    virtual FieldSample at(const glm::dvec3& tip) const noexcept = 0;
    /// Largest error of `clearance` in the fine band, down to a voxel inside, where the part's faces are smooth, mm; <=
    /// 0.05 voxel. Elsewhere it may be below the true clearance by more, or above it by up to `errorBoundAt`.
    virtual double errorBound() const noexcept = 0;
    /// How much `clearance` at a tip may be above the true one, down to a voxel inside, mm; also at sharp edges. Any
    /// thread; no allocation.
    virtual double errorBoundAt(const glm::dvec3&) const noexcept { return errorBound(); }
    /// Edge of a fine cell, mm.
    virtual double spacing() const noexcept = 0;
};

/// The clearance of a tool with axis +Z, its tip at a point, from the part: the part grown by flutes, shank and holder,
/// as one field over tips. Fine bricks of 8 x 8 x 8 cells from 3 voxels inside to maximumAllowance + 4 voxels outside,
/// coarse ones beyond, whose value is a distance that the tip can travel safely. Immutable. README.md beside this
/// header explains the resolution and the basis of the bound.
class ToolField final : public ClearanceField {
public:
    /// Cost: seconds; parallel. Errors: cancelled, outOfMemory, argumentInvalid (a voxel that is not > 0, a box of tips
    /// that is empty or not finite, no tool).
    static Result<ToolField> build(const MeshDistance& part, const ToolFieldRequest& request, Progress& progress);
    ~ToolField() override;
    ToolField(ToolField&&) noexcept;
    ToolField& operator=(ToolField&&) noexcept;

    /// Trilinear value and gradient. Outside the box of tips: the value of its nearest point, and not fine.
    FieldSample at(const glm::dvec3& tip) const noexcept override;
    double errorBound() const noexcept override;
    /// The bound of the brick that contains the tip; 0 for coarse ones.
    double errorBoundAt(const glm::dvec3& tip) const noexcept override;
    double spacing() const noexcept override;
    std::size_t memoryBytes() const noexcept;

private:
    explicit ToolField(std::unique_ptr<const BrickField> bricks);
    std::unique_ptr<const BrickField> bricks_;
};

} // namespace burin
