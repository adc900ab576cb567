// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/workpiece_measure.h"

#include "core/volume/operations/ray_cast.h"
#include "core/volume/surface/fitted_face.h"

#include <algorithm>
#include <cmath>
#include <new>

namespace burin {

namespace {

/// Rays start this far outside the surface, and this much of them is ignored when they look for other material: within
/// a voxel, a scanline may be in or out.
constexpr double besideSurface = 1.0; // voxels

MeasuredFace faceFrom(const FittedFace& fitted) {
    MeasuredFace face;
    face.place = face.corner = fitted.place;
    face.normal = fitted.normal;
    if (!fitted.surface) return face;
    const FittedSurface& surface = *fitted.surface;
    face.radius = surface.radius;
    face.axisPlace = surface.place;
    switch (surface.kind) {
    case FittedSurface::Kind::plane:
        face.kind = MeasuredFace::Kind::plane;
        break;
    case FittedSurface::Kind::cylinder:
        face.kind = MeasuredFace::Kind::cylinder;
        face.axis = surface.axis;
        break;
    case FittedSurface::Kind::sphere:
        face.kind = MeasuredFace::Kind::sphere;
        break;
    }
    return face;
}

/// A ray from a point of the surface, and what limits how exactly its lengths are known.
class SurfaceRay {
public:
    /// @param direction unit
    SurfaceRay(const VolumeSnapshot& workpiece, const FittedFace& face, const glm::dvec3& direction)
        : workpiece_(workpiece), face_(face), direction_(direction) {
        // Obliquely it takes longer to leave the voxels of the surface.
        ignored_ = besideSurface * workpiece.grid().edge() / std::max(std::abs(glm::dot(direction, face.normal)), 0.2);
    }
    /// Into the material to where it ends; empty if it is not there.
    std::optional<MeasuredLength> thickness() const {
        for (const RayInterval& interval : materialAlong(workpiece_, face_.place - ignored_ * direction_, direction_)) {
            if (interval.from > 2.0 * ignored_) break;
            if (interval.to > 1.25 * ignored_) return length(interval.to - ignored_);
        }
        return std::nullopt;
    }
    /// Through the air to other material.
    std::optional<MeasuredLength> opening() const {
        for (const RayInterval& interval : materialAlong(workpiece_, face_.place, direction_)) {
            if (interval.from > ignored_) return length(interval.from);
            if (interval.to > 2.0 * ignored_) break;
        }
        return std::nullopt;
    }

private:
    /// The other end has a face of its own, which is only known to be exact if it is met along a scanline.
    MeasuredLength length(double value) const {
        const double own = face_.within / std::max(std::abs(glm::dot(direction_, face_.normal)), 0.2);
        return {value, own + surfaceUncertainty(workpiece_.grid(), direction_)};
    }

    const VolumeSnapshot& workpiece_;
    const FittedFace& face_;
    glm::dvec3 direction_;
    double ignored_ = 0.0; ///< mm
};

std::string materialAt(const VolumeSnapshot& workpiece, const FittedFace& face) {
    const double edge = workpiece.grid().edge();
    const std::optional<RayHit> hit = castRay(workpiece, face.place + besideSurface * edge * face.normal, -face.normal);
    return hit ? workpiece.properties()[hit->property].id : std::string();
}

Result<MeasuredWorkpiece> measuredAt(const VolumeSnapshot& workpiece, const WorkpieceReference& reference,
                                     const WorkpiecePoint& point) {
    const std::optional<FittedFace> fitted = fittedFaceAt(workpiece, point.place);
    if (!fitted) return Error{ErrorCode::argumentInvalid, "workpiece", {}, "a workpiece with material"};
    MeasuredWorkpiece measured;
    measured.face = faceFrom(*fitted);
    measured.within = fitted->within;
    measured.radiusWithin = fitted->radiusWithin;
    measured.angleWithin = fitted->angleWithin;
    if (const std::optional<MeasuredLength> wall = SurfaceRay(workpiece, *fitted, -fitted->normal).thickness()) {
        measured.face.thickness = wall->value;
        measured.thicknessWithin = wall->within;
    }
    if (point.direction) measured.along = SurfaceRay(workpiece, *fitted, glm::normalize(*point.direction)).thickness();
    measured.opening = SurfaceRay(workpiece, *fitted, fitted->normal).opening();
    measured.depth = reference.stockTop - fitted->place.z;
    measured.depthWithin = fitted->within * std::abs(fitted->normal.z);
    if (reference.part != nullptr && !reference.part->triangles().empty())
        measured.fromPart = reference.part->closest(fitted->place).signedDistance;
    measured.material = materialAt(workpiece, *fitted);
    return measured;
}

bool isSound(const WorkpiecePoint& point) {
    return isFinite(point.place) &&
           (!point.direction || (isFinite(*point.direction) && *point.direction != glm::dvec3(0.0)));
}

} // namespace

Result<WorkpieceMeasure> measureWorkpiece(const VolumeSnapshot& workpiece, const WorkpieceReference& reference,
                                          const WorkpiecePoint& from, const std::optional<WorkpiecePoint>& to,
                                          Progress& progress) try {
    if (!isSound(from) || (to && !isSound(*to)))
        return Error{ErrorCode::argumentInvalid, "place", {}, "a finite place"};
    const Result<MeasuredWorkpiece> first = measuredAt(workpiece, reference, from);
    if (!first) return first.error();
    WorkpieceMeasure measure{*first};
    if (!to) return measure;
    if (progress.cancelled()) return Error{ErrorCode::cancelled, {}, {}, {}};
    progress.report(0.5);
    const Result<MeasuredWorkpiece> second = measuredAt(workpiece, reference, *to);
    if (!second) return second.error();
    measure.to = *second;
    measure.pairWithin = first->within + second->within;
    measure.angleWithin = first->angleWithin + second->angleWithin;
    measure.pair = pairOf(measure.from.face, measure.to->face, std::max(measure.angleWithin, 1e-3));
    return measure;
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, "faces", {}, {}};
}

} // namespace burin
