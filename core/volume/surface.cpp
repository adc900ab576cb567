// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface.h"

#include "core/volume/surface_materials.h"
#include "core/volume/surface_net.h"
#include "core/volume/surface_search.h"
#include "core/volume/surface_simplification.h"

namespace burin {

void SurfaceMesh::clear() {
    points.clear();
    normals.clear();
    properties.clear();
    triangles.clear();
}

class SurfaceExtractor::Storage {
public:
    /// Adds the surface in one window.
    void add(const VolumeSnapshot& workpiece, const SurfaceWindow& window, SurfaceMesh& mesh) {
        const std::size_t before = mesh.points.size();
        lines.read(workpiece, window);
        net.make(window, lines, workpiece.grid(), before);
        mesh.points.insert(mesh.points.end(), net.points().begin(), net.points().end());
        mesh.normals.insert(mesh.normals.end(), net.normals().begin(), net.normals().end());
        mesh.triangles.insert(mesh.triangles.end(), net.triangles().begin(), net.triangles().end());
        const PropertyIndex only = lines.onlyProperty();
        mesh.properties.resize(mesh.points.size(), only);
        if (only == airProperty)
            materials.find(workpiece, window, lines, net.points(), net.normals().data(),
                           mesh.properties.data() + before);
    }

    SurfaceSearch search;
    SurfaceLines lines;
    SurfaceNet net;
    SurfaceMaterials materials;
    SurfaceSimplifier simplifier;
};

SurfaceExtractor::SurfaceExtractor() : storage_(std::make_unique<Storage>()) {}
SurfaceExtractor::~SurfaceExtractor() = default;
SurfaceExtractor::SurfaceExtractor(SurfaceExtractor&&) noexcept = default;
SurfaceExtractor& SurfaceExtractor::operator=(SurfaceExtractor&&) noexcept = default;

void SurfaceExtractor::extract(const VolumeSnapshot& workpiece, SurfaceTile tile, const SurfaceDetail& detail,
                               SurfaceMesh& mesh) {
    mesh.clear();
    const Grid& grid = workpiece.grid();
    for (const int piece : storage_->search.pieces(workpiece, tile, detail.level))
        storage_->add(workpiece, SurfaceWindow::of(grid, tile, piece, detail.level), mesh);
    if (detail.tolerance > 0.0)
        storage_->simplifier.simplify(mesh, detail.tolerance, grid.edge() * (1 << detail.level));
}

void SurfaceExtractor::extractBrick(const VolumeSnapshot& workpiece, SurfaceBrick brick, SurfaceMesh& mesh) {
    mesh.clear();
    storage_->add(workpiece, SurfaceWindow::of(workpiece.grid(), {brick.u, brick.v}, brick.n, 0), mesh);
}

glm::ivec2 surfaceTiles(const Grid& grid) {
    return (glm::ivec2(grid.lineCountU(), grid.lineCountV()) + linesPerSurfaceTile - 1) / linesPerSurfaceTile;
}

} // namespace burin
