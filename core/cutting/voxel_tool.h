// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cutting/removed_units.h"
#include "core/geometry/pose.h"
#include "core/geometry/revolved_piece.h"
#include "core/volume/runs/run_volume.h"

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// The material that one cut of a voxel tool removed.
struct VoxelCut {
    RunAmounts removed;       ///< by the flutes, by property, run units; whole voxels of machinable material
    double volume = 0.0;      ///< mm³, of all that was removed
    glm::dvec3 centroid{0.0}; ///< mm, of what was removed, setup frame; meaningless when volume is 0
    RunAmounts touched;       ///< overlap of the shank by property, run units, summed over the poses: not removed
    double unitVolume = 0.0;  ///< mm³ of a run unit
    std::int32_t poses = 0;   ///< number of poses used
    bool outOfMemory = false; ///< reserved memory of the workpiece is used up; the remaining voxels are uncut

    /// Returns the removed volume of a property, mm³.
    double removedVolume(PropertyIndex property) const noexcept {
        return static_cast<double>(removed.units[property]) * unitVolume;
    }
};

/// A tool of any shape, stored as S-RLE: flutes and shank are two properties of one volume (paper, 2 and eq. 3). It is
/// moved by the paper's method: poses are interpolated between two cycles (eqs. 6, 7), so many that no voxel of the
/// tool moves a whole voxel between two of them (eq. 8); their union is the swept volume (eqs. 9, 10), which is
/// subtracted from the workpiece (4.3): VR = Vs ∩ Vw. A voxel of the workpiece belongs to the tool at a pose if its
/// centre, transformed back into the tool's frame, lies in a voxel of the tool; the forward transformation of a rotated
/// tool would leave holes. Cuts whole voxels. The remaining surface lies within 0.87 voxel of the tool's (half its
/// diagonal), plus half of the distance that a point moves between two poses. Cost: the voxels in the tool's box for
/// each pose. Intended for tools that are not solids of revolution, and as the reference for the analytic sweep; not
/// for the haptic tick.
class VoxelTool {
public:
    static constexpr PropertyIndex flutes = 1, shank = 2;

    /// @param shape tool frame: tip at the origin, axis +Z towards the holder; `flutes` and `shank` as properties.
    /// Errors: argumentInvalid (a shape without any voxel, or with other properties).
    static Result<VoxelTool> make(RunVolume shape);
    /// Makes a tool of the voxels whose centres lie in the pieces of a tool. @param edge of a voxel, mm
    /// Errors: argumentInvalid, volumeTooLarge, outOfMemory.
    static Result<VoxelTool> ofPieces(std::span<const RevolvedPiece> pieces, std::size_t fluteCount, double edge);

    const RunVolume& shape() const noexcept { return shape_; }
    /// Returns the number of poses for a motion, both ends included (eq. 8).
    std::int32_t posesFor(const Pose& from, const Pose& to) const noexcept;
    /// Returns one of these poses (eqs. 6, 7): the tip moves along a straight line at constant speed, the tool rotates
    /// at constant speed about one axis, in the direction of the smaller angle.
    /// @param k     0 … poses - 1
    /// @param poses posesFor(from, to)
    static Pose poseOf(const Pose& from, const Pose& to, std::int32_t k, std::int32_t poses) noexcept;
    /// Returns the property of the voxel around a point, mm, tool frame.
    PropertyIndex at(const glm::dvec3& place) const noexcept;
    /// Returns a box around the tool at a pose, mm, setup frame; empty for a pose that is not finite.
    Box boundsAt(const Pose& pose) const noexcept;
    /// Removes the flutes at all poses from the machinable runs of a workpiece. Poses that are not finite remove
    /// nothing.
    VoxelCut cut(RunVolume& workpiece, const Pose& from, const Pose& to) const noexcept;

private:
    explicit VoxelTool(RunVolume shape) noexcept;
    bool cutAt(RunVolume& workpiece, const Pose& pose, VoxelCut& cut, RemovedUnits& removed) const noexcept;

    RunVolume shape_;
    Box filled_;         ///< mm, tool frame, of the voxels that are not air
    double reach_ = 0.0; ///< mm, of the farthest of them from the tip
};

/// Returns the properties of a tool's volume, at the indices of `VoxelTool::flutes` and `VoxelTool::shank`.
PropertyList toolProperties();

/// Returns the collision area (paper, eq. 4) of a tool of any shape: surface voxels of its shank that are surface
/// voxels of the workpiece, ordered by scanline (v, then u), then along it. Voxels belong to the shank as they do in a
/// cut, and to a surface if one of their 26 neighbours does not belong. Empty for a pose that is not finite. Not for
/// the tick: allocates.
std::vector<VoxelIndex> collisionArea(const VolumeSnapshot& workpiece, const VoxelTool& tool, const Pose& pose);

} // namespace burin
