// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/gizmo_geometry.h"

#include "core/base/units.h"

#include <QPolygonF>

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {

namespace {

constexpr double leastSine = 0.17; // 10°: between an arrow and the sight line, and between that and a square or a ring
constexpr double facing = 0.94;    // cosine of 20°: a ring turned less than this away from the eye is drawn as a whole
constexpr int ringSteps = 32;      // of half a ring

/// Of a segment on the screen: the distance of its nearest point from the pointer, and that point's share of it.
struct ScreenDistance {
    double pixels = 0.0, share = 0.0;
};

ScreenDistance distanceTo(const QPointF& from, const QPointF& to, const QPointF& pointer) {
    const QPointF along = to - from, offset = pointer - from;
    const double square = QPointF::dotProduct(along, along);
    const double share = square > 0.0 ? std::clamp(QPointF::dotProduct(offset, along) / square, 0.0, 1.0) : 0.0;
    const QPointF gap = offset - share * along;
    return {std::hypot(gap.x(), gap.y()), share};
}

/// How near the gripped point of a handle is to the eye, mm from the centre; empty: the pointer doesn't grip it.
std::optional<double> nearness(const GizmoLine& line, const GizmoHandle& handle, const glm::dvec3& centre,
                               const glm::dvec3& eye, const CameraView& view, const QSizeF& size,
                               const QPointF& pointer) {
    std::vector<QPointF> seen;
    for (const glm::dvec3& point : line) seen.push_back(appearanceOf(view, size, point));
    std::optional<double> nearest;
    const auto take = [&](const glm::dvec3& point) {
        const double depth = glm::dot(point - centre, eye);
        if (!nearest || depth > *nearest) nearest = depth;
    };
    if (handle.part == GizmoPart::square &&
        QPolygonF(QList<QPointF>(seen.begin(), seen.end())).containsPoint(pointer, Qt::OddEvenFill))
        take(0.5 * (line[0] + line[2]));
    for (std::size_t i = 0; i + 1 < seen.size(); ++i) {
        const ScreenDistance distance = distanceTo(seen[i], seen[i + 1], pointer);
        if (distance.pixels <= gizmoReach) take(glm::mix(line[i], line[i + 1], distance.share));
    }
    return nearest;
}

} // namespace

glm::dvec3 axisDirection(int axis) noexcept {
    glm::dvec3 direction(0.0);
    direction[axis] = 1.0;
    return direction;
}

glm::dvec3 towardsEye(const CameraView& view, const glm::dvec3& place) noexcept {
    const CameraAxes axes = axesOf(view);
    return isParallel(view) ? axes.back : glm::normalize(axes.eye - place);
}

std::vector<GizmoHandle> offeredHandles(const Gizmo& gizmo, const CameraView& view) {
    const glm::dvec3 eye = towardsEye(view, gizmo.centre);
    std::vector<GizmoHandle> handles;
    for (int axis = 0; axis < 3; ++axis) {
        const double along = std::abs(eye[axis]);
        if (1.0 - along * along > leastSine * leastSine) handles.push_back({GizmoPart::arrow, axis});
        if (along <= leastSine) continue;
        handles.push_back({GizmoPart::square, axis});
        if (gizmo.rotates && (!gizmo.upright || axis == 2)) handles.push_back({GizmoPart::ring, axis});
    }
    return handles;
}

GizmoLine handleLine(const Gizmo& gizmo, const GizmoHandle& handle, const CameraView& view, double pixel) {
    const glm::dvec3 axis = axisDirection(handle.axis), u = axisDirection((handle.axis + 1) % 3),
                     v = axisDirection((handle.axis + 2) % 3);
    GizmoLine line;
    const auto add = [&](const glm::dvec3& offset) { line.emplace_back(gizmo.centre + pixel * offset); };
    if (handle.part == GizmoPart::arrow) {
        add(gizmoArrowStart * axis);
        add(gizmoArrowLength * axis);
    } else if (handle.part == GizmoPart::square) {
        for (const auto& [across, up] :
             {std::pair(gizmoSquareStart, gizmoSquareStart), std::pair(gizmoSquareEnd, gizmoSquareStart),
              std::pair(gizmoSquareEnd, gizmoSquareEnd), std::pair(gizmoSquareStart, gizmoSquareEnd),
              std::pair(gizmoSquareStart, gizmoSquareStart)})
            add(across * u + up * v);
    } else {
        const glm::dvec3 eye = towardsEye(view, gizmo.centre);
        const bool whole = std::abs(eye[handle.axis]) >= facing;
        const double middle = whole ? 0.0 : std::atan2(glm::dot(eye, v), glm::dot(eye, u)),
                     half = whole ? pi : 0.5 * pi;
        const int steps = whole ? 2 * ringSteps : ringSteps;
        for (int i = 0; i <= steps; ++i) {
            const double angle = middle - half + 2.0 * half * i / steps;
            add(gizmoRingRadius * (std::cos(angle) * u + std::sin(angle) * v));
        }
    }
    return line;
}

std::optional<GizmoHandle> handleAt(const Gizmo& gizmo, const CameraView& view, const QSizeF& size,
                                    const QPointF& pointer) {
    const double pixel = pixelAt(view, size, gizmo.centre);
    const glm::dvec3 eye = towardsEye(view, gizmo.centre);
    std::optional<GizmoHandle> gripped;
    double nearest = 0.0;
    for (const GizmoHandle& handle : offeredHandles(gizmo, view)) {
        const GizmoLine line = handleLine(gizmo, handle, view, pixel);
        const std::optional<double> depth = nearness(line, handle, gizmo.centre, eye, view, size, pointer);
        if (!depth || (gripped && *depth <= nearest)) continue;
        gripped = handle;
        nearest = *depth;
    }
    return gripped;
}

} // namespace burin
