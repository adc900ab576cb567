// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface_cubes.h"
#include "core/volume/surface/surface_faces.h"
#include "core/volume/surface/surface_field.h"
#include "core/volume/surface/surface_points.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace burin {

/// Surface nets (Gibson 1998): one point for every cube of eight nodes that the surface crosses, in the middle of the
/// crossings on its edges, and a quadrangle around every crossed edge. A window owns the edges that start at its own
/// nodes; the points beside its border come out alike in both windows.
class SurfaceNet {
public:
    /// Makes what is added from now on the first in a mesh, which must stay. What it holds is written over, and only
    /// what is not enough added to: a mesh that is made again and again costs no room that is cleared first.
    void start(SurfaceMesh& mesh);
    /// Adds points, normals and triangles of a window. The mesh's vectors are longer than what is used of them then;
    /// behind the last point `SurfaceFrame::spare` more may be read.
    void add(const SurfaceWindow& window, const SurfaceLines& lines, const Grid& grid);
    std::size_t pointCount() const { return pointCount_; }
    /// Leaves in the mesh what was added; of properties there is one a point then.
    void finish();

private:
    void addCubes(int row);
    void addBatch();
    void addFaces();
    void writeFaces();

    SurfaceField field_;
    SurfaceCubes cubes_;
    SurfaceBatch batch_; ///< cubes whose points are to be added
    SurfaceEdges edges_; ///< of the batch that was added last
    SurfaceFaces faces_;
    SurfaceFrame frame_;
    int firstRow_ = 0; ///< of the batch
    /// Points by the place of their cube, of the last rows; only those of cubes that are crossed are set. In front of
    /// the first row stands the last one again, and places that faces look back at.
    static constexpr std::size_t placesBefore = SurfaceField::mostPlaces + SurfaceField::mostNodes + 1;
    std::array<std::uint32_t, placesBefore + SurfaceFrame::rowsKept * SurfaceField::mostPlaces> pointAt_;
    SurfaceMesh* mesh_ = nullptr;
    std::size_t pointCount_ = 0, cornerCount_ = 0;
};

} // namespace burin
