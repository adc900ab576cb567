// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/geometry/triangle_mesh.h"
#include "core/volume/runs/run_volume.h"

#include <span>
#include <vector>

namespace burin {

/// A body to be filled into a volume.
struct BodyMesh {
    const TriangleMesh* mesh = nullptr; ///< closed, mm; the caller's
    PropertyIndex property = airProperty;
    int priority = 0; ///< where bodies overlap the highest has the place; among equals the later in the list
};

/// Scanlines that a rule had to decide.
struct DoubtfulLines {
    std::size_t count = 0;
    Box place; ///< from the first to the last place on them, of overlaps of what is held twice; mm, empty for none

    void add(const DoubtfulLines& other) noexcept {
        count += other.count;
        place.include(other.place);
    }
};

/// What voxelising a mesh found out about it.
struct VoxelisationReport {
    std::size_t linesWithOddCrossings = 0; ///< scanlines that pass a hole: the open surface has an odd number of places
    DoubtfulLines throughHoles;            ///< those, and the ones that pass several holes: filled by the rule for them
    DoubtfulLines turnedFaces;             ///< faces do not agree on what is outside: filled by parity
    DoubtfulLines insideOut;               ///< a whole shell is turned inwards, but not a cavity of another
    DoubtfulLines overlaps;                ///< shells of the mesh enter each other, by more than 1/16 voxel of the line
    std::size_t clippedLines = 0;          ///< scanlines on which the mesh reached out of the grid
    std::size_t openEdges = 0, holes = 0;  ///< edges of no or one neighbour that are not slits; rims they form
    std::size_t duplicateTriangles = 0;    ///< left out
    std::uint64_t filledUnits = 0;         ///< run units inside the mesh
    RunAmounts replaced;                   ///< what stood there before, bodies filled earlier included

    /// Whether it was one clean closed shell as far as the scanlines tell, or several that are in order.
    bool clean() const noexcept {
        return openEdges == 0 && turnedFaces.count == 0 && insideOut.count == 0 && overlaps.count == 0 &&
               duplicateTriangles == 0;
    }
};

/// Fills the inside of meshes, each with its property. Run ends lie where the scanline's centre crosses the surface, to
/// 1/256 voxel. Across the runs, vertices are taken to the nearest 1/65,536 voxel. A place exactly on a triangle's edge
/// is decided once for all triangles that share it, so that a closed mesh never gives an odd line.
///
/// Rules, for what is not one clean closed shell:
/// - Shells that overlap: inside is where the winding number is not zero; warned of where it goes beyond one, but not
///   of shells that touch. A shell turned inwards within another is a cavity. Which way a single shell is turned does
///   not matter.
/// - A line on which windings do not close, as faces disagree: parity of its crossings.
/// - Triangles without area cross nothing. A triangle that is there twice, turned alike, counts once, in a mesh that is
///   open else. Slits up to 1/16 voxel wide between open edges close (their vertices move by no more than that).
/// - A hole's rim is closed by a cone to its middle, the cap. A line that meets caps is cut into pieces at surface and
///   caps; a piece is inside where the generalised winding number of the surface at its middle is above 1/2, that is,
///   where the surface takes up more than half of the view (Jacobson, Kavan & Sorkine-Hornung 2013). So a plane hole in
///   a closed shape ends in its plane. Beyond 20,000 open edges the caps are taken for surface.
/// They hold for any run axis. What is inside by parity or by a hole's rule is a guess, and warned of.
///
/// Bodies are filled in the order of their priorities, equal ones in the order of the list; the result is that of one
/// after the other. Reports are in the order of the list.
/// Cost: time and memory (8 bytes a crossing, 24 a vertex) linear in triangles and crossings; besides, lines through
/// holes times open edges. Parallel. Errors: volumeOutOfMemory, cancelled (some lines are filled then), argumentInvalid
/// (a vertex that is not finite or half a million times farther away than the largest grid reaches), outOfMemory.
Result<std::vector<VoxelisationReport>> voxelise(std::span<const BodyMesh> bodies, RunVolume& volume,
                                                 Progress& progress);

/// One body.
Result<VoxelisationReport> voxelise(const TriangleMesh& mesh, PropertyIndex property, RunVolume& volume,
                                    Progress& progress);

} // namespace burin
