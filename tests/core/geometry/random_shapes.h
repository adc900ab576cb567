// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"
#include "core/geometry/revolved_piece.h"

#include <rapidcheck.h>

#include <cmath>
#include <cstdint>
#include <vector>

/// Random numbers, points and tools for properties. A thousand steps per unit, so that shrinking ends soon.
namespace burin::random {

inline double number(double low, double high) {
    return low + (high - low) * 1e-4 * *rc::gen::inRange<std::int32_t>(0, 10001);
}

inline glm::dvec3 point(double reach) {
    const double x = number(-reach, reach), y = number(-reach, reach), z = number(-reach, reach);
    return {x, y, z};
}

inline glm::dvec3 direction() {
    const glm::dvec3 v = point(1.0);
    return glm::length(v) > 1e-3 ? glm::normalize(v) : glm::dvec3(0.0, 0.0, 1.0);
}

/// Ball, flat, bull nose, a frustum that widens or narrows, or the zone of a sphere or torus.
inline RevolvedPiece piece() {
    const double bottom = number(0.0, 3.0), radius = number(0.2, 4.0), length = number(1.0, 12.0);
    switch (*rc::gen::inRange(0, 6)) {
    case 4:
    case 5: {
        const double ring = *rc::gen::element(0.0, 1.0, -1.0) * number(0.05, 0.9) * radius;
        const double limit = ring < 0.0 ? std::acos(-ring / radius) : std::asin(1.0);
        const double from = number(-1.0, 0.9) * limit, to = from + number(0.05, 1.0) * (limit - from);
        return bulgingPiece(bottom + radius * std::sin(from), bottom + radius * std::sin(to), ring, bottom, radius);
    }
    case 0:
        return {bottom, bottom + radius + length, radius, radius, radius};
    case 1:
        return {bottom, bottom + length, radius, radius, 0.0};
    case 2:
        return {bottom, bottom + radius + length, radius, radius, radius * number(0.05, 0.95)};
    default:
        return {bottom, bottom + length, radius, number(0.0, 5.0), 0.0};
    }
}

/// Two pieces, the second on top of the first.
inline std::vector<RevolvedPiece> stack() {
    const RevolvedPiece lower = piece();
    RevolvedPiece upper = piece();
    const double lift = lower.top - upper.bottom;
    upper.bottom = lower.top;
    upper.top += lift;
    upper.bulgeCentreHeight += lift;
    return {lower, upper};
}

} // namespace burin::random
