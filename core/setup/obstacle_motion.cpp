// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/obstacle_motion.h"

#include "core/base/units.h"

#include <cmath>

namespace burin {

namespace {

constexpr double uprightWithin = 1e-12; // of 1 - cos

void moveShape(Box& box, const Placement& by) {
    box = boxAround(box, by);
}

void moveShape(CylinderShape& cylinder, const Placement& by) {
    cylinder.base = by.point(cylinder.base);
    cylinder.axis = glm::normalize(by.direction(cylinder.axis)); // many rotations don't add up their rounding
}

void moveShape(TriangleMesh& mesh, const Placement& by) {
    for (glm::dvec3& vertex : mesh.vertices) vertex = by.point(vertex);
}

/// Whether it leaves an upright object upright.
bool keepsUpright(const Placement& by) noexcept {
    return by.turn[2].z > 1.0 - uprightWithin;
}

} // namespace

HeldRotations heldRotations(const Obstacle& obstacle) noexcept {
    if (obstacle.design) return HeldRotations::aboutZ;
    return std::holds_alternative<Box>(obstacle.shape) ? HeldRotations::quarterTurns : HeldRotations::any;
}

Result<Obstacle> moved(const Obstacle& obstacle, const Placement& by) {
    const HeldRotations held = heldRotations(obstacle);
    if (held == HeldRotations::quarterTurns && !alongAxes(by))
        return Error{ErrorCode::argumentInvalid,
                     obstacle.name,
                     {},
                     "a rotation by a multiple of 90 degrees: the edges of a box stay parallel to the axes"};
    if (held == HeldRotations::aboutZ && !keepsUpright(by))
        return Error{ErrorCode::argumentInvalid, obstacle.name, {}, "a rotation about Z: the fixture stands upright"};
    Obstacle result = obstacle;
    std::visit([&](auto& shape) { moveShape(shape, by); }, result.shape);
    if (result.design) {
        result.design->place = by.point(result.design->place);
        result.design->turn = std::remainder(result.design->turn + std::atan2(by.turn[0].y, by.turn[0].x), 2.0 * pi);
    }
    return result;
}

} // namespace burin
