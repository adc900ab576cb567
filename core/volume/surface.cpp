// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface.h"

#include "core/volume/surface_net.h"
#include "core/volume/surface_search.h"
#include "core/volume/surface_simplification.h"
#include "core/volume/volume_access.h"

#include <algorithm>
#include <array>

namespace burin {

namespace {

/// Material under points of the surface.
class MaterialUnder {
public:
    explicit MaterialUnder(const VolumeSnapshot& workpiece)
        : grid_(workpiece.grid())
        , properties_(workpiece.properties())
        , state_(VolumeAccess::state(workpiece))
        , axes_{grid_.axisOfU(), grid_.axisOfV(), grid_.axisOfRuns()}
        , voxelsPerMillimetre_(1.0 / grid_.edge()) {}

    /// The part where it lies within a voxel (a finishing pass leaves a film of some hundredths of a millimetre, which
    /// nobody would call stock), else the first that is not air on the way in. A coarse surface may lie that much
    /// farther out.
    PropertyIndex operator()(const glm::vec3& point, const glm::vec3& normal, int cell, bool lookForPart) const {
        const glm::dvec3 place = inVoxels(glm::dvec3(point) - grid_.low()) * voxelsPerMillimetre_;
        const glm::dvec3 out = inVoxels(glm::dvec3(normal));
        PropertyIndex found = airProperty;
        for (const double depth : {0.3, 0.6, 0.9, 1.3, 1.8, 1.8 * cell}) {
            const PropertyIndex property = at(place - depth * out);
            if (depth < 1.0 && properties_.isProtected(property)) return property;
            if (found == airProperty) found = property;
            if (found != airProperty && (depth >= 0.9 || !lookForPart)) break;
        }
        return found != airProperty ? found : beside(place);
    }

private:
    glm::dvec3 inVoxels(const glm::dvec3& way) const { return {way[axes_[0]], way[axes_[1]], way[axes_[2]]}; }
    /// Of a splinter thinner than that: the first that is found in the voxels around. Without it a brick, which knows
    /// that there is one material alone, would differ from its tile.
    PropertyIndex beside(const glm::dvec3& place) const {
        for (int u = -1; u <= 1; ++u)
            for (int v = -1; v <= 1; ++v)
                for (int n = -2; n <= 2; ++n) {
                    const PropertyIndex property = at(place + glm::dvec3(u, v, 0.5 * n));
                    if (property != airProperty) return property;
                }
        return airProperty;
    }
    PropertyIndex at(const glm::dvec3& place) const {
        const auto within = [](double count, std::int32_t limit) {
            return std::clamp(static_cast<std::int32_t>(count), 0, limit - 1);
        };
        const LineIndex line{within(place[0], grid_.lineCountU()), within(place[1], grid_.lineCountV())};
        const auto position = static_cast<std::int64_t>(place[2] * unitsPerVoxel + 0.5);
        for (const Segment segment : state_.store->line(state_.pages, line))
            if (position < std::int64_t{segment.end()}) return segment.property();
        return airProperty;
    }

    const Grid& grid_;
    const PropertyList& properties_;
    const VolumeState& state_;
    std::array<int, 3> axes_;
    double voxelsPerMillimetre_;
};

} // namespace

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
        lines.read(workpiece, window);
        const std::size_t before = mesh.points.size();
        net.add(window, lines, workpiece.grid(), mesh);
        const PropertyIndex only = lines.onlyProperty();
        mesh.properties.resize(mesh.points.size(), only);
        if (only != airProperty) return;
        const MaterialUnder material(workpiece);
        const bool lookForPart = lines.holdsProtected(workpiece.properties());
        for (std::size_t i = before; i < mesh.points.size(); ++i)
            mesh.properties[i] = material(mesh.points[i], mesh.normals[i], window.cell(), lookForPart);
    }

    SurfaceSearch search;
    SurfaceLines lines;
    SurfaceNet net;
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
