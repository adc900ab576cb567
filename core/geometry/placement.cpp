// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/placement.h"

#include "core/geometry/frame_along.h"
#include "core/geometry/pose.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace burin {

namespace {

/// Generous bound of the error of the cosine of a quarter turn in a double.
constexpr double roundingOfTurns = 1e-12;
constexpr double roundingOfStored = 1e-9;

bool isWhole(double entry, double rounding) noexcept {
    return std::abs(entry - std::round(entry)) <= rounding;
}

bool isWhole(const glm::dmat3& turn, double rounding) noexcept {
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (!isWhole(turn[column][row], rounding)) return false;
    return true;
}

/// Quarter turns have entries of 0, 1 and -1, and must have exactly these.
glm::dmat3 exact(glm::dmat3 turn) noexcept {
    if (isWhole(turn, roundingOfTurns))
        for (int column = 0; column < 3; ++column) turn[column] = glm::round(turn[column]) + glm::dvec3(0.0);
    return turn;
}

Placement about(const glm::dmat3& turn, const glm::dvec3& through) noexcept {
    return {turn, through - turn * through};
}

} // namespace

bool isNone(const Placement& placement) noexcept {
    return placement == Placement{};
}

bool mirrors(const Placement& placement) noexcept {
    return glm::determinant(placement.turn) < 0.0;
}

bool isSound(const Placement& placement) noexcept {
    const glm::dmat3 product = glm::transpose(placement.turn) * placement.turn;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) // an entry that is NaN fails the test as well
            if (!(std::abs(product[column][row] - (column == row ? 1.0 : 0.0)) <= roundingOfStored)) return false;
    return isFinite(placement.shift);
}

bool alongAxes(const Placement& placement) noexcept {
    return isWhole(placement.turn, 0.0);
}

Placement combined(const Placement& first, const Placement& second) noexcept {
    return {exact(second.turn * first.turn), second.turn * first.shift + second.shift};
}

Placement inverse(const Placement& placement) noexcept {
    const glm::dmat3 back = glm::transpose(placement.turn);
    return {back, -(back * placement.shift)};
}

Placement turnedAbout(const glm::dvec3& axis, double angle, const glm::dvec3& through) noexcept {
    return about(exact(glm::dmat3(glm::rotate(glm::dmat4(1.0), angle, glm::normalize(axis)))), through);
}

Placement turnedTowards(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& through) noexcept {
    const glm::dvec3 start = glm::normalize(from), end = glm::normalize(to);
    const glm::dvec3 axis = glm::cross(start, end);
    const double sine = glm::length(axis), cosine = glm::dot(start, end);
    if (sine > roundingOfTurns) return turnedAbout(axis, std::atan2(sine, cosine), through);
    if (cosine > 0.0) return {};
    const glm::dvec3 x(1.0, 0.0, 0.0), y(0.0, 1.0, 0.0);
    const glm::dvec3 across = std::abs(start.x) < 0.9 ? x : y;
    return turnedAbout(across - glm::dot(across, start) * start, std::acos(-1.0), through);
}

Placement movedBy(const glm::dvec3& by) noexcept {
    return {glm::dmat3(1.0), by};
}

Placement mirroredAcross(int axis, const glm::dvec3& through) noexcept {
    glm::dmat3 mirror(1.0);
    mirror[axis][axis] = -1.0;
    return about(mirror, through);
}

Box boxAround(const Box& box, const Placement& placement) noexcept {
    if (box.empty()) return box;
    const Box turned = boxAround(box, placement.turn);
    return {turned.low + placement.shift, turned.high + placement.shift};
}

} // namespace burin
