// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface.h"

#include "core/volume/surface_net.h"
#include "core/volume/surface_simplification.h"

#include <algorithm>
#include <array>

namespace burin {

namespace {

PropertyIndex propertyAt(const VolumeSnapshot& workpiece, const glm::dvec3& place) {
    const Grid& grid = workpiece.grid();
    const glm::ivec3 index =
        glm::clamp(glm::ivec3(glm::floor((place - grid.low()) / grid.edge())), glm::ivec3(0), grid.count() - 1);
    const RunPosition position = grid.toRunPosition(place[grid.axisOfRuns()]);
    for (const Segment segment : workpiece.line({index[grid.axisOfU()], index[grid.axisOfV()]}))
        if (position < segment.end()) return segment.property();
    return airProperty;
}

/// Material under a point of the surface: the part where it lies within a voxel (a finishing pass leaves a film of
/// some hundredths of a millimetre, which nobody would call stock), else the first that is not air on the way in.
/// A coarse surface may lie that much farther out.
PropertyIndex propertyUnder(const VolumeSnapshot& workpiece, const glm::dvec3& place, const glm::dvec3& normal,
                            int cell) {
    PropertyIndex found = airProperty;
    for (const double depth : {0.3, 0.6, 0.9, 1.3, 1.8, 1.8 * cell}) { // voxels
        const PropertyIndex property = propertyAt(workpiece, place - normal * (depth * workpiece.grid().edge()));
        if (depth < 1.0 && workpiece.properties().isProtected(property)) return property;
        if (found == airProperty) found = property;
    }
    return found;
}

} // namespace

void SurfaceMesh::clear() {
    points.clear();
    normals.clear();
    properties.clear();
    triangles.clear();
}

class SurfaceExtractor::Storage {
public:
    SurfaceField field;
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
    SurfaceField& field = storage_->field;
    field.aim(workpiece, tile, detail.level);
    for (const SurfaceField::Interval interval : field.intervals()) {
        field.fill(workpiece, interval);
        storage_->net.add(field, workpiece.grid(), mesh);
    }
    if (field.onlyProperty() != airProperty)
        mesh.properties.assign(mesh.points.size(), field.onlyProperty());
    else
        for (std::size_t point = 0; point < mesh.points.size(); ++point)
            mesh.properties.push_back(propertyUnder(workpiece, mesh.points[point], mesh.normals[point], field.cell()));
    if (detail.tolerance > 0.0)
        storage_->simplifier.simplify(mesh, detail.tolerance, field.cell() * workpiece.grid().edge());
}

glm::ivec2 surfaceTiles(const Grid& grid) {
    return (glm::ivec2(grid.lineCountU(), grid.lineCountV()) + linesPerSurfaceTile - 1) / linesPerSurfaceTile;
}

} // namespace burin
