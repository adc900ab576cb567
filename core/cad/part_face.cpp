// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/part_face.h"

#include "core/cad/worker_process.h"
#include "core/geometry/pose.h"
#include "core/geometry/triangle.h"

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <variant>

namespace burin {

namespace {

/// Returns the nearest of the triangle's corners and midpoints of its edges.
glm::dvec3 cornerOf(const Triangle& triangle, const glm::dvec3& place) {
    const std::array places{triangle[0],
                            triangle[1],
                            triangle[2],
                            0.5 * (triangle[0] + triangle[1]),
                            0.5 * (triangle[1] + triangle[2]),
                            0.5 * (triangle[2] + triangle[0])};
    return *std::ranges::min_element(places, {},
                                     [&place](const glm::dvec3& corner) { return glm::distance(corner, place); });
}

/// Returns the nearest triangle as a face.
PartFace triangleAt(const Model& model, const glm::dvec3& place) {
    PartFace found;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Body& body : model.bodies)
        for (const auto& triangle : body.mesh.triangles) {
            const Triangle corners{body.mesh.vertices[triangle[0]], body.mesh.vertices[triangle[1]],
                                   body.mesh.vertices[triangle[2]]};
            const glm::dvec3 normal = areaNormal(corners), foot = closestOnTriangle(corners, place).point;
            const double distance = glm::distance(foot, place);
            if (!(glm::length(normal) > 0.0) || distance >= nearest) continue;
            nearest = distance;
            found = {PartFace::Kind::plane, foot, glm::normalize(normal), cornerOf(corners, place)};
        }
    return found;
}

} // namespace

Result<PartFace> partFaceAt(const Model& model, const glm::dvec3& place, const ImportOptions& options,
                            Progress& progress) try {
    const std::string subject = "B-rep";
    if (!isFinite(place)) return Error{ErrorCode::argumentInvalid, "place", {}, "a finite place"};
    if (model.bodies.empty()) return Error{ErrorCode::argumentInvalid, "place", {}, "a model with a body"};
    if (model.brep.empty()) return triangleAt(model, place);
    const FaceRequest request{model.brep, model.brepSolids, inverse(model.brepPlacement).point(place)};
    auto answers = runWorkers({request}, options, subject, progress);
    if (!answers) return std::move(answers).error();
    auto* face = std::get_if<PartFace>(&answers->front());
    if (!face) return Error{ErrorCode::importCrashed, subject, {}, "it answered something else"};
    face->place = model.brepPlacement.point(face->place);
    face->direction = model.brepPlacement.direction(face->direction);
    face->corner = model.brepPlacement.point(face->corner);
    return *face;
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, "faces", {}, {}};
}

} // namespace burin
