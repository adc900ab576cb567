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

class CutCache;

/// A touched material and the volume of overlap.
struct TouchedProperty {
    PropertyIndex property = airProperty; ///< air: entry not used
    bool isProtected = false;             ///< the part, or another protected material in the volume; else stock
    double volume = 0.0;                  ///< mm³ of overlap
};

/// Overlap of a part of the tool that must not touch anything with the content of a volume: stock, part, and any
/// fixture that is a material of it. Burin's own setups keep fixtures out of the volume (core/setup/obstacle.h), so
/// they never appear here: a boundary keeps the whole tool away from them (core/haptics/boundary/tool_boundaries.h),
/// and programs are checked against their meshes (core/verify/obstacles.h).
struct ShankContact {
    bool touches = false;
    std::uint32_t piece = 0;                  ///< index in pieces(cutter) of the piece that overlaps most: see
                                              ///< sectionOf
    PropertyIndex property = airProperty;     ///< the touched property with the most overlap
    glm::dvec3 place{0.0};                    ///< mm, centre of the overlap, setup frame
    double volume = 0.0;                      ///< mm³ of overlap
    bool touchesStock = false;                ///< something machinable is touched
    bool touchesProtected = false;            ///< something protected is touched
    std::array<TouchedProperty, 4> touched{}; ///< the four with the most overlap, in descending order
};

/// Checks shank and holder for contact with everything in a workpiece, tick by tick (paper, 4.2). Remembers which
/// bricks of the volume were empty, so that a tool in free space costs only a check of the blocks beneath it and reads
/// no scanline. Works for any axis of the tool and any axis of the runs. A scanline counts if it overlaps a piece by
/// more than a quarter of a voxel, or by more than half the height of a shorter piece. Use one object for each volume;
/// between two calls of `at` the volume may only lose material, otherwise call `forget`. Only on the writer's thread.
/// No allocation, lock or exception after construction.
class ContactCheck {
public:
    explicit ContactCheck(const Grid& grid) : bricks_(grid) {}

    /// @param tool pieces(cutter)
    /// @param fluteCount number of pieces, from the tip, that may touch: flutePieces(cutter).size()
    /// @param window pending writes of deferred cuts (MaterialRemoval::window), which count as removed; null: none
    /// A pose that is not finite touches nothing.
    ShankContact at(const RunVolume& workpiece, std::span<const RevolvedPiece> tool, std::size_t fluteCount,
                    const ToolPose& pose, const CutCache* window = nullptr) noexcept;
    /// Call after the volume changed in any other way than by cutting.
    void forget() noexcept { bricks_.forget(); }

private:
    OccupiedBricks bricks_;
};

/// The same for a single check, without memory of empty bricks; axis +Z.
/// @param tool pieces(cutter) of a cutter whose flutes are one piece, which may touch.
ShankContact shankContact(const RunVolume& workpiece, std::span<const RevolvedPiece> tool,
                          const glm::dvec3& tip) noexcept;
/// @param fluteCount number of the tool's pieces, from the tip, that may touch.
ShankContact shankContact(const RunVolume& workpiece, std::span<const RevolvedPiece> tool, std::size_t fluteCount,
                          const ToolPose& pose) noexcept;

/// Returns the collision area (paper, eq. 4): surface voxels of shank and holder that are surface voxels of the
/// workpiece, ordered by scanline (v, then u), then along it. A voxel belongs to the tool if its centre lies in one of
/// the pieces, and to a surface if one of its 26 neighbours does not belong. Not for the tick: allocates.
std::vector<VoxelIndex> collisionArea(const VolumeSnapshot& workpiece, std::span<const RevolvedPiece> tool,
                                      std::size_t fluteCount, const ToolPose& pose);

} // namespace burin
