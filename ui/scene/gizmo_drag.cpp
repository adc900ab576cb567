// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/gizmo_drag.h"

#include "core/base/units.h"
#include "ui/scene/gizmo_geometry.h"

#include <cmath>

namespace burin {

namespace {

constexpr double edgeSine = 0.26;       // 15°: below it between a ring and the sight line, its tangent is followed
constexpr double parallelSine = 0.0087; // half a degree

double rounded(double value, double step) noexcept {
    return step > 0.0 ? step * std::round(value / step) : value;
}

} // namespace

std::optional<glm::dvec3> onPlane(const Sight& sight, const glm::dvec3& place, const glm::dvec3& normal) noexcept {
    const double slope = glm::dot(sight.direction, normal);
    if (std::abs(slope) < parallelSine) return std::nullopt;
    const double distance = glm::dot(place - sight.origin, normal) / slope;
    if (distance < 0.0) return std::nullopt;
    return sight.origin + distance * sight.direction;
}

GizmoDrag::GizmoDrag(const GizmoHandle& handle, const glm::dvec3& centre, const Sight& start, double radius)
    : handle_(handle), centre_(centre), axis_(axisDirection(handle.axis)), radius_(radius) {
    const double slope = glm::dot(start.direction, axis_);
    if (handle.part == GizmoPart::ring && std::abs(slope) < edgeSine)
        edge_ = -glm::normalize(start.direction - slope * axis_);
    last_ = positionOn(start);
}

/// On the axis, in the plane, or on the tangent; from the centre, mm.
std::optional<glm::dvec3> GizmoDrag::positionOn(const Sight& sight) const noexcept {
    const auto along = [&](const glm::dvec3& place, const glm::dvec3& axis) -> std::optional<glm::dvec3> {
        const std::optional<double> position = alongAxis(sight, place, axis);
        return position ? std::optional(*position * axis) : std::nullopt;
    };
    if (handle_.part == GizmoPart::arrow) return along(centre_, axis_);
    if (edge_) return along(centre_ + radius_ * *edge_, glm::cross(axis_, *edge_));
    const std::optional<glm::dvec3> point = onPlane(sight, centre_, axis_);
    return point ? std::optional(*point - centre_) : std::nullopt;
}

void GizmoDrag::follow(const Sight& sight, double share) {
    const std::optional<glm::dvec3> position = positionOn(sight);
    if (!position) return;
    const glm::dvec3 before = last_.value_or(*position);
    last_ = position;
    if (handle_.part != GizmoPart::ring) {
        shift_ += share * (*position - before);
    } else if (edge_) {
        angle_ += share * glm::dot(*position - before, glm::cross(axis_, *edge_)) / radius_;
    } else {
        // Between two events the pointer goes by less than half a turn.
        const glm::dvec3 turn = glm::cross(before, *position);
        angle_ += share * std::atan2(glm::dot(turn, axis_), glm::dot(before, *position));
    }
}

GizmoMotion GizmoDrag::motion(const GizmoSteps& steps) const noexcept {
    GizmoMotion motion;
    for (int axis = 0; axis < 3; ++axis) motion.shift[axis] = rounded(shift_[axis], steps.length);
    motion.angle = rounded(angle_, steps.angle);
    return motion;
}

} // namespace burin
