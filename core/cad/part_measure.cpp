// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/part_measure.h"

#include "core/cad/part_face.h"
#include "core/cad/worker_process.h"
#include "core/geometry/pose.h"
#include "core/geometry/triangle.h"
#include "core/geometry/triangle_ray.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <variant>

namespace burin {

namespace {

using Kind = MeasuredFace::Kind;

constexpr double behindFace = 1e-6; // mm, the part of a ray that is ignored when looking for the opposite side

bool isRound(const MeasuredFace& face) noexcept {
    return face.kind == Kind::cylinder || face.kind == Kind::cone || face.kind == Kind::torus;
}

/// The angle between two lines through the origin, 0 … π / 2; precise also for nearly parallel lines.
double acuteAngle(const glm::dvec3& one, const glm::dvec3& other) {
    return std::atan2(glm::length(glm::cross(one, other)), std::abs(glm::dot(one, other)));
}

double fromAxis(const glm::dvec3& place, const MeasuredFace& round) {
    return glm::length(glm::cross(place - round.axisPlace, round.axis));
}

double fromPlane(const glm::dvec3& place, const MeasuredFace& plane) {
    return std::abs(glm::dot(place - plane.place, plane.normal));
}

/// Returns the distance from the point straight in to the first triangle where the ray leaves the material.
std::optional<double> thicknessAt(const Model& model, const MeasuredFace& face) {
    const Ray in{face.place, -face.normal};
    std::optional<double> nearest;
    for (const Body& body : model.bodies)
        for (const auto& triangle : body.mesh.triangles) {
            const Triangle corners{body.mesh.vertices[triangle[0]], body.mesh.vertices[triangle[1]],
                                   body.mesh.vertices[triangle[2]]};
            const std::optional<TriangleHit> hit = hitOf(in, corners);
            if (hit && hit->leaving && hit->distance > behindFace && (!nearest || hit->distance < *nearest))
                nearest = hit->distance;
        }
    return nearest;
}

/// Measures the triangle at a point.
Result<MeasuredFace> measuredTriangle(const Model& model, const glm::dvec3& place, const ImportOptions& options,
                                      Progress& progress) {
    const Result<PartFace> triangle = partFaceAt(model, place, options, progress);
    if (!triangle) return triangle.error();
    MeasuredFace face;
    face.kind = Kind::plane;
    face.place = triangle->place;
    face.corner = triangle->corner;
    face.normal = triangle->direction;
    face.thickness = thicknessAt(model, face);
    return face;
}

Result<PartMeasure> ofMesh(const Model& model, const glm::dvec3& from, const std::optional<glm::dvec3>& to,
                           const ImportOptions& options, Progress& progress) {
    const Result<MeasuredFace> first = measuredTriangle(model, from, options, progress);
    if (!first) return first.error();
    PartMeasure measure{*first};
    if (!to) return measure;
    const Result<MeasuredFace> second = measuredTriangle(model, *to, options, progress);
    if (!second) return second.error();
    measure.to = *second;
    measure.pair = pairOf(measure.from, *measure.to);
    return measure;
}

void moveTo(const Placement& placement, MeasuredFace& face) {
    face.place = placement.point(face.place);
    face.corner = placement.point(face.corner);
    face.normal = placement.direction(face.normal);
    face.axis = placement.direction(face.axis);
    face.axisPlace = placement.point(face.axisPlace);
}

} // namespace

const char* idOf(MeasuredFace::Kind kind) {
    switch (kind) {
    case Kind::plane:
        return "plane";
    case Kind::cylinder:
        return "cylinder";
    case Kind::cone:
        return "cone";
    case Kind::sphere:
        return "sphere";
    case Kind::torus:
        return "torus";
    case Kind::other:
        break;
    }
    return "other";
}

MeasuredPair pairOf(const MeasuredFace& from, const MeasuredFace& to, double parallel) {
    MeasuredPair pair;
    pair.places = glm::distance(from.place, to.place);
    pair.corners = glm::distance(from.corner, to.corner);
    pair.nearestFrom = from.place;
    pair.nearestTo = to.place;
    const bool planes = from.kind == Kind::plane && to.kind == Kind::plane, rounds = isRound(from) && isRound(to);
    if (planes || rounds) {
        pair.angle = planes ? acuteAngle(from.normal, to.normal) : acuteAngle(from.axis, to.axis);
        if (*pair.angle <= parallel) pair.apart = planes ? fromPlane(to.place, from) : fromAxis(to.axisPlace, from);
    } else if ((from.kind == Kind::plane && isRound(to)) || (isRound(from) && to.kind == Kind::plane)) {
        const MeasuredFace &plane = from.kind == Kind::plane ? from : to, &round = from.kind == Kind::plane ? to : from;
        pair.angle = std::max(0.0, std::acos(0.0) - acuteAngle(plane.normal, round.axis));
        if (*pair.angle <= parallel) pair.apart = fromPlane(round.axisPlace, plane);
    }
    return pair;
}

Result<PartMeasure> measurePart(const Model& model, const glm::dvec3& from, const std::optional<glm::dvec3>& to,
                                const ImportOptions& options, Progress& progress) try {
    const std::string subject = "B-rep";
    if (!isFinite(from) || (to && !isFinite(*to)))
        return Error{ErrorCode::argumentInvalid, "place", {}, "a finite place"};
    if (model.bodies.empty()) return Error{ErrorCode::argumentInvalid, "place", {}, "a model with a body"};
    if (model.brep.empty()) return ofMesh(model, from, to, options, progress);
    const Placement inward = inverse(model.brepPlacement);
    MeasureRequest request{model.brep, model.brepSolids, {inward.point(from)}};
    if (to) request.places.push_back(inward.point(*to));
    auto answers = runWorkers({request}, options, subject, progress);
    if (!answers) return std::move(answers).error();
    auto* measure = std::get_if<PartMeasure>(&answers->front());
    if (!measure) return Error{ErrorCode::importCrashed, subject, {}, "it answered something else"};
    moveTo(model.brepPlacement, measure->from);
    if (measure->to) moveTo(model.brepPlacement, *measure->to);
    if (measure->pair) {
        measure->pair->nearestFrom = model.brepPlacement.point(measure->pair->nearestFrom);
        measure->pair->nearestTo = model.brepPlacement.point(measure->pair->nearestTo);
    }
    return *measure;
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, "faces", {}, {}};
}

} // namespace burin
