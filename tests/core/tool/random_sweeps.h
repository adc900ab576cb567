// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/revolved_piece.h"

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

/// Random pieces of tools and moves of them.
namespace burin::random {

inline double real(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6;
}

/// Ball, flat, bull nose, frusta; all pieces that have a closed form for upright moves.
inline RevolvedPiece straightPiece() {
    const double bottom = real(-2.0, 2.0), radius = real(0.2, 4.0), other = real(0.2, 4.0);
    const double top = bottom + real(4.0, 9.0);
    switch (*rc::gen::inRange(0, 5)) {
    case 0:
        return {bottom, top, radius, radius, radius}; // ball
    case 1:
        return {bottom, top, radius, radius, 0.0}; // flat end, shank
    case 2:
        return {bottom, top, radius, radius, radius * real(0.02, 0.98)}; // bull nose
    case 3:
        return {bottom, top, std::min(radius, other), std::max(radius, other), 0.0};
    default:
        return {bottom, top, std::max(radius, other), std::min(radius, other), 0.0};
    }
}

/// Zone of a sphere, or of a torus whose ring is at a positive radius or beyond the axis.
inline RevolvedPiece roundPiece() {
    const double radius = real(0.5, 5.0), height = real(-3.0, 8.0);
    const double ring = *rc::gen::element(0.0, 1.0, -1.0) * real(0.05, 0.9) * radius;
    // Angles of the zone's ends, where its profile does not cross the axis.
    const double limit = ring < 0.0 ? std::acos(-ring / radius) : std::asin(1.0);
    const double one = real(-1.0, 1.0) * limit, two = real(-1.0, 1.0) * limit;
    const double low = std::min(one, two), high = std::max(std::max(one, two), low + 0.05);
    return bulgingPiece(height + radius * std::sin(low), height + radius * std::sin(std::min(high, limit)), ring,
                        height, radius);
}

/// Also cone tips, which end in a point.
inline RevolvedPiece anyPiece() {
    switch (*rc::gen::inRange(0, 8)) {
    case 0:
    case 1:
    case 2:
        return roundPiece();
    case 3:
        return {0.0, real(0.2, 4.0), 0.0, real(0.2, 4.0), 0.0};
    default:
        return straightPiece();
    }
}

inline glm::dvec3 move() {
    const glm::dvec3 any(real(-6.0, 6.0), real(-6.0, 6.0), real(-6.0, 6.0));
    switch (*rc::gen::inRange(0, 8)) {
    case 0:
        return glm::dvec3(0.0);
    case 1:
        return {0.0, 0.0, any.z};
    case 2:
        return {any.x, 0.0, 0.0};
    case 3:
        return {any.x, any.y, 0.0};
    case 4:
        return any * 1e-3;
    case 5:
        return any * 1e-8;
    case 6:
        return {any.x * 1e-4, any.y * 1e-4, any.z}; // steep
    default:
        return any;
    }
}

/// Any direction, and directions parallel or nearly parallel to the frame's axes.
inline glm::dvec3 axis() {
    const glm::dvec3 any(real(-1.0, 1.0), real(-1.0, 1.0), real(-1.0, 1.0));
    const glm::dvec3 level(any.x, any.y, 0.0);
    const double sign = any.z < 0.0 ? -1.0 : 1.0;
    switch (*rc::gen::inRange(0, 8)) {
    case 0:
        return {sign, 0.0, 0.0};
    case 1:
        return {0.0, sign, 0.0};
    case 2:
        return {0.0, 0.0, sign};
    case 3:
        return glm::length(level) > 1e-3 ? glm::normalize(level) : glm::dvec3(1.0, 0.0, 0.0);
    case 4:
        return glm::normalize(glm::dvec3(any.x * 1e-4, any.y * 1e-4, sign));
    default:
        return glm::length(any) > 1e-3 ? glm::normalize(any) : glm::dvec3(0.0, 0.0, 1.0);
    }
}

/// Parallel to the axis, perpendicular to it or any: the kinds of outlines of a moved piece differ.
inline glm::dvec3 moveFor(const glm::dvec3& axis) {
    const glm::dvec3 any = move();
    switch (*rc::gen::inRange(0, 4)) {
    case 0:
        return glm::dot(any, axis) * axis;
    case 1:
        return any - glm::dot(any, axis) * axis;
    default:
        return any;
    }
}

} // namespace burin::random
