// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/arc.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double radiusTolerance = 0.0282842712474619; // mm: 4 sqrt(2) times half a step of two decimals
constexpr double radiusTolerancePart = 0.001;          // of the radius

/// The two axes of the arc's plane, in the order in which an anticlockwise turn goes.
struct Plane {
    int first, second;
};
constexpr Plane planeOf(int axis) noexcept {
    return {(axis + 1) % 3, (axis + 2) % 3};
}

/// Arc in polar coordinates of its plane.
struct Turn {
    double startRadius = 0.0, endRadius = 0.0, startAngle = 0.0, sweep = 0.0;
};
Turn turnOf(const Arc& arc) noexcept {
    const auto [u, v] = planeOf(arc.axis);
    const glm::dvec3 start = arc.from - arc.centre, end = arc.to - arc.centre;
    Turn turn;
    turn.startRadius = std::hypot(start[u], start[v]);
    turn.endRadius = std::hypot(end[u], end[v]);
    turn.startAngle = std::atan2(start[v], start[u]);
    double sweep = std::atan2(end[v], end[u]) - turn.startAngle;
    // Ends that are equal but for rounding are a full turn, as the control reads them.
    constexpr double sameAngle = 1e-12;
    if (arc.clockwise) {
        while (sweep >= -sameAngle) sweep -= 2.0 * pi;
    } else {
        while (sweep <= sameAngle) sweep += 2.0 * pi;
    }
    turn.sweep = sweep;
    return turn;
}

} // namespace

const char* faultOf(const Arc& arc) noexcept {
    const Turn turn = turnOf(arc);
    if (turn.startRadius < 1e-9 || turn.endRadius < 1e-9) return "arc of radius zero";
    const double difference = std::abs(turn.startRadius - turn.endRadius);
    if (difference > 100.0 * radiusTolerance ||
        (difference > radiusTolerance && difference > radiusTolerancePart * std::max(turn.startRadius, turn.endRadius)))
        return "radius at the end of the arc differs from the radius at its start";
    return nullptr;
}

void flatten(const Arc& arc, std::vector<glm::dvec3>& places) {
    const auto [u, v] = planeOf(arc.axis);
    const Turn turn = turnOf(arc);
    const double radius = std::max(turn.startRadius, turn.endRadius);
    const double step = 2.0 * std::acos(std::max(0.5, 1.0 - arcChordTolerance / radius));
    const auto count = static_cast<std::size_t>(std::ceil(std::abs(turn.sweep) / step));
    places.clear();
    places.reserve(count);
    for (std::size_t i = 1; i < count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(count);
        const double angle = turn.startAngle + part * turn.sweep;
        const double r = turn.startRadius + part * (turn.endRadius - turn.startRadius);
        glm::dvec3 place = arc.from + part * (arc.to - arc.from);
        place[u] = arc.centre[u] + r * std::cos(angle);
        place[v] = arc.centre[v] + r * std::sin(angle);
        places.push_back(place);
    }
    places.push_back(arc.to);
}

} // namespace burin
