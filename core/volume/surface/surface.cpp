// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface/surface.h"

#include "core/volume/surface/surface_materials.h"
#include "core/volume/surface/surface_net.h"
#include "core/volume/surface/surface_search.h"
#include "core/volume/surface/surface_simplification.h"

#include <algorithm>

namespace burin {

void SurfaceMesh::clear() {
    points.clear();
    normals.clear();
    properties.clear();
    triangles.clear();
}

class SurfaceExtractor::Storage {
public:
    /// Adds the surface in one window to the mesh that the net was started with.
    void add(const VolumeSnapshot& workpiece, const SurfaceWindow& window, SurfaceMesh& mesh) {
        const std::size_t before = net.pointCount();
        lines.read(workpiece, window);
        net.add(window, lines, workpiece.grid());
        const std::size_t count = net.pointCount() - before;
        if (mesh.properties.size() < before + count) mesh.properties.resize(before + count);
        const PropertyIndex only = lines.onlyProperty();
        if (only != airProperty)
            std::fill_n(mesh.properties.data() + before, count, only);
        else
            materials.find(workpiece, window, lines, std::span(mesh.points).subspan(before, count),
                           mesh.normals.data() + before, mesh.properties.data() + before);
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
    const Grid& grid = workpiece.grid();
    storage_->net.start(mesh);
    for (const int piece : storage_->search.pieces(workpiece, tile, detail.level))
        storage_->add(workpiece, SurfaceWindow::of(grid, tile, piece, detail.level), mesh);
    storage_->net.finish();
    if (detail.tolerance > 0.0)
        storage_->simplifier.simplify(mesh, detail.tolerance, grid.edge() * (1 << detail.level));
}

void SurfaceExtractor::extractBrick(const VolumeSnapshot& workpiece, SurfaceBrick brick, SurfaceMesh& mesh) {
    storage_->net.start(mesh);
    storage_->add(workpiece, SurfaceWindow::of(workpiece.grid(), {brick.u, brick.v}, brick.n, 0), mesh);
    storage_->net.finish();
}

glm::ivec2 surfaceTiles(const Grid& grid) {
    return (glm::ivec2(grid.lineCountU(), grid.lineCountV()) + linesPerSurfaceTile - 1) / linesPerSurfaceTile;
}

} // namespace burin
