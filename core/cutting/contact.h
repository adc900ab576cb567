// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/occupied_bricks.h"
#include "core/geometry/pose.h"
#include "core/geometry/revolved_piece.h"
#include "core/volume/runs/run_volume.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

class GapWindow;

/// What is touched, and by how much.
struct TouchedProperty {
    PropertyIndex property = airProperty; ///< air: entry not used
    bool isProtected = false;             ///< the part, or what else is protected in the volume; else stock
    double volume = 0.0;                  ///< mm³ of overlap
};

/// Where a part of the tool that must not touch anything overlaps what a volume holds: stock, part, and any fixture
/// that is a material of it. Burin's own setups keep fixtures out of the volume (core/setup/obstacle.h), so those never
/// show up here: the hand is held off them with the whole tool (core/haptics/boundary/tool_boundaries.h), and programs
/// are judged against them by their meshes (core/verify/obstacles.h).
struct ShankContact {
    bool touches = false;
    std::uint32_t piece = 0;                  ///< place in pieces(cutter) of what overlaps most: see sectionOf
    PropertyIndex property = airProperty;     ///< what is touched, most of it
    glm::dvec3 place{0.0};                    ///< mm, centre of the overlap, setup frame
    double volume = 0.0;                      ///< mm³ of overlap
    bool touchesStock = false;                ///< something machinable is touched
    bool touchesProtected = false;            ///< something protected is touched
    std::array<TouchedProperty, 4> touched{}; ///< the four with most overlap, most first
};

/// Contact of shank and holder with everything in a workpiece, tick by tick (paper, 4.2). Remembers which bricks of the
/// volume were empty, so that a tool in free space costs a look at the blocks beneath it and no scanline. Any axis of
/// the tool, any axis of the runs. A scanline counts when it overlaps a piece by more than a quarter of a voxel, or by
/// more than half the height of a shorter piece. One object a volume; between two calls of `at` the volume may only
/// lose material, else `forget`. Thread: the writer's. No allocation, lock or exception after construction.
class ContactCheck {
public:
    explicit ContactCheck(const Grid& grid) : bricks_(grid) {}

    /// @param tool pieces(cutter)
    /// @param fluteCount so many of them, from the tip, may touch: flutePieces(cutter).size()
    /// @param window what the workpiece is owed where cuts are deferred (MaterialRemoval::window): that counts as gone;
    /// null: nothing
    /// A pose that is not finite touches nothing.
    ShankContact at(const RunVolume& workpiece, std::span<const RevolvedPiece> tool, std::size_t fluteCount,
                    const ToolPose& pose, const GapWindow* window = nullptr) noexcept;
    /// The volume changed otherwise than by cutting.
    void forget() noexcept { bricks_.forget(); }

private:
    OccupiedBricks bricks_;
};

/// The same without a memory, for one look; axis +Z.
/// @param tool pieces(cutter) of a cutter whose flutes are one piece; it may touch.
ShankContact shankContact(const RunVolume& workpiece, std::span<const RevolvedPiece> tool,
                          const glm::dvec3& tip) noexcept;
/// @param fluteCount so many of the tool's pieces, from the tip, may touch.
ShankContact shankContact(const RunVolume& workpiece, std::span<const RevolvedPiece> tool, std::size_t fluteCount,
                          const ToolPose& pose) noexcept;

/// The collision area (paper, eq. 4): surface voxels of shank and holder that are surface voxels of the workpiece, by
/// scanlines (v, then u), then along them. A voxel belongs to the tool when its centre lies in one of the pieces, and
/// to a surface when one of its 26 neighbours does not belong. Not for the tick: allocates.
std::vector<VoxelIndex> collisionArea(const VolumeSnapshot& workpiece, std::span<const RevolvedPiece> tool,
                                      std::size_t fluteCount, const ToolPose& pose);

} // namespace burin
