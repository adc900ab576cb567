// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/arc.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// The two axes of the arc's plane, in the order of an anticlockwise rotation.
struct Plane {
    int first, second;
};
constexpr Plane planeOf(int axis) noexcept {
    return {(axis + 1) % 3, (axis + 2) % 3};
}

} // namespace

ArcTurn turnOf(const Arc& arc) noexcept {
    const auto [u, v] = planeOf(arc.axis);
    const glm::dvec3 start = arc.from - arc.centre, end = arc.to - arc.centre;
    ArcTurn turn;
    turn.startRadius = std::hypot(start[u], start[v]);
    turn.endRadius = std::hypot(end[u], end[v]);
    turn.startAngle = std::atan2(start[v], start[u]);
    double sweep = std::atan2(end[v], end[u]) - turn.startAngle;
    // Ends that are equal except for rounding mean a full turn, as controls interpret them.
    constexpr double sameAngle = 1e-12;
    if (arc.clockwise) {
        while (sweep >= -sameAngle) sweep -= 2.0 * pi;
    } else {
        while (sweep <= sameAngle) sweep += 2.0 * pi;
    }
    turn.sweep = sweep;
    return turn;
}

glm::dvec3 placeOn(const Arc& arc, const ArcTurn& turn, double share) noexcept {
    if (share <= 0.0) return arc.from;
    if (share >= 1.0) return arc.to;
    const auto [u, v] = planeOf(arc.axis);
    const double angle = turn.startAngle + share * turn.sweep;
    const double radius = turn.startRadius + share * (turn.endRadius - turn.startRadius);
    glm::dvec3 place = arc.from + share * (arc.to - arc.from);
    place[u] = arc.centre[u] + radius * std::cos(angle);
    place[v] = arc.centre[v] + radius * std::sin(angle);
    return place;
}

double lengthOf(const Arc& arc, const ArcTurn& turn) noexcept {
    constexpr double coincident = 1e-9; // mm: radii that differ by no more than this are those of a circle
    const double rise = arc.to[arc.axis] - arc.from[arc.axis];
    if (std::abs(turn.endRadius - turn.startRadius) <= coincident)
        return std::hypot(turn.startRadius * turn.sweep, rise);
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(turn.sweep) * 512.0 / (2.0 * pi))));
    double length = 0.0;
    glm::dvec3 last = arc.from;
    for (int i = 1; i <= steps; ++i) {
        const glm::dvec3 next = placeOn(arc, turn, static_cast<double>(i) / steps);
        length += glm::distance(last, next);
        last = next;
    }
    return length;
}

void flatten(const Arc& arc, double chordTolerance, std::vector<glm::dvec3>& places) {
    const ArcTurn turn = turnOf(arc);
    const double radius = std::max(turn.startRadius, turn.endRadius);
    const double step = 2.0 * std::acos(std::max(0.5, 1.0 - chordTolerance / radius));
    const auto count = static_cast<std::size_t>(std::ceil(std::abs(turn.sweep) / step));
    places.clear();
    places.reserve(count);
    for (std::size_t i = 1; i < count; ++i)
        places.push_back(placeOn(arc, turn, static_cast<double>(i) / static_cast<double>(count)));
    places.push_back(arc.to);
}

} // namespace burin
