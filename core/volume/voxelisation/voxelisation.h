// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/geometry/triangle_mesh.h"
#include "core/volume/runs/run_volume.h"

#include <span>
#include <vector>

namespace burin {

/// A body to fill into a volume.
struct BodyMesh {
    const TriangleMesh* mesh = nullptr; ///< closed, mm; owned by the caller
    PropertyIndex property = airProperty;
    int priority = 0; ///< where bodies overlap the highest wins; among equals the later one in the list
};

/// Scanlines for which one of the rules for irregular meshes decided.
struct DoubtfulLines {
    std::size_t count = 0;
    Box place; ///< bounding box from the first to the last affected point on them (for overlaps, of the part that is
               ///< inside twice); mm, empty if there are none

    void add(const DoubtfulLines& other) noexcept {
        count += other.count;
        place.include(other.place);
    }
};

/// What was found out about a mesh while voxelising it.
struct VoxelisationReport {
    std::size_t linesWithOddCrossings = 0; ///< scanlines that cross the open surface an odd number of times: through a
                                           ///< hole
    DoubtfulLines throughHoles;            ///< those, and lines through several holes: filled by the rule for holes
    DoubtfulLines turnedFaces;             ///< orientation of faces is inconsistent: filled by parity
    DoubtfulLines insideOut;               ///< a whole shell is oriented inwards, but is not a cavity of another
    DoubtfulLines overlaps;                ///< shells of the mesh overlap by more than 1/16 voxel along the line
    std::size_t clippedLines = 0;          ///< scanlines on which the mesh extends beyond the grid
    std::size_t openEdges = 0,
                holes = 0; ///< edges shared by an odd number of triangles that are not slits; rims they form
    std::size_t duplicateTriangles = 0; ///< ignored triangles
    std::uint64_t filledUnits = 0;      ///< run units inside the mesh
    RunAmounts replaced;                ///< what was there before, including bodies filled earlier

    /// Whether the mesh is one clean closed shell, or several valid ones, as far as the scanlines show.
    bool clean() const noexcept {
        return openEdges == 0 && turnedFaces.count == 0 && insideOut.count == 0 && overlaps.count == 0 &&
               duplicateTriangles == 0;
    }
};

/// Fills the inside of meshes, each with its property. Run ends lie where the centre line of the scanline crosses the
/// surface, to 1/256 voxel. Across the runs, vertices are rounded to the nearest 1/65,536 voxel. A point exactly on a
/// triangle's edge is decided in the same way for all triangles that share it, so that a closed mesh never gives a line
/// with an odd number of crossings.
///
/// Rules for meshes that are not one clean closed shell:
/// - Overlapping shells: inside is where the winding number is not zero; reported where it exceeds one, but not for
/// shells that only touch. A shell oriented inwards within another is a cavity. The orientation of a single shell does
/// not matter.
/// - A line on which the winding numbers do not close, because the orientation of faces is inconsistent: parity of its
/// crossings.
/// - Triangles without area cross nothing. A triangle that occurs twice with the same orientation counts once, if the
/// mesh is open otherwise. Slits up to 1/16 voxel wide between open edges are closed (their vertices move by no more
/// than that).
/// - The rim of a hole is closed by a cone to its middle, the cap. A line that meets caps is cut into pieces at surface
/// and caps; a piece is inside if the generalised winding number of the surface at its middle is above 1/2, that is, if
/// the surface covers more than half of the view (Jacobson, Kavan & Sorkine-Hornung 2013). So a planar hole in a closed
/// shape ends in its plane. Beyond 20,000 open edges the caps are treated as surface.
/// They apply to any run axis. What is inside by parity or by the rule for holes is a guess, and reported.
///
/// Bodies are filled in the order of their priorities, equal ones in the order of the list; the result is the same as
/// filling one after the other. Reports are in the order of the list.
/// Cost: time and memory (8 bytes per crossing, 24 per vertex) linear in triangles and crossings; in addition, lines
/// through holes times open edges. Parallel. Errors: volumeOutOfMemory, cancelled (some lines are then filled),
/// argumentInvalid (a vertex that is not finite or is half a million times farther away than the largest grid reaches),
/// outOfMemory.
Result<std::vector<VoxelisationReport>> voxelise(std::span<const BodyMesh> bodies, RunVolume& volume,
                                                 Progress& progress);

/// The same for a single body.
Result<VoxelisationReport> voxelise(const TriangleMesh& mesh, PropertyIndex property, RunVolume& volume,
                                    Progress& progress);

} // namespace burin
