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
/// crossings on its edges, and a quadrilateral around every crossed edge. A window owns the edges that start at its own
/// nodes; points beyond its border are identical in both windows.
class SurfaceNet {
public:
    /// Starts a new surface in a mesh, which must stay valid. The mesh's previous content is overwritten and its
    /// vectors only grow if necessary: a mesh that is made repeatedly needs no memory to be cleared first.
    void start(SurfaceMesh& mesh);
    /// Adds points, normals and triangles of a window. The mesh's vectors are then longer than their used part;
    /// `SurfaceFrame::spare` more may be read behind the last point.
    void add(const SurfaceWindow& window, const SurfaceLines& lines, const Grid& grid);
    std::size_t pointCount() const { return pointCount_; }
    /// Shrinks the mesh's vectors to what was added; afterwards there is one property per point.
    void finish();

private:
    void addCubes(int row);
    void addBatch();
    void addFaces();
    void writeFaces();

    SurfaceField field_;
    SurfaceCubes cubes_;
    SurfaceBatch batch_; ///< cubes whose points are still to be added
    SurfaceEdges edges_; ///< of the batch that was added last
    SurfaceFaces faces_;
    SurfaceFrame frame_;
    int firstRow_ = 0; ///< of the batch
    /// Point numbers by the index of their cube, for the last rows; only those of crossed cubes are set. In front of
    /// the first row is a copy of the last one, and indices that faces look back at.
    static constexpr std::size_t placesBefore = SurfaceField::mostPlaces + SurfaceField::mostNodes + 1;
    std::array<std::uint32_t, placesBefore + SurfaceFrame::rowsKept * SurfaceField::mostPlaces> pointAt_;
    SurfaceMesh* mesh_ = nullptr;
    std::size_t pointCount_ = 0, cornerCount_ = 0;
};

} // namespace burin
