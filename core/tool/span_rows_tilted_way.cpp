// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/span_rows_tilted.h"

#include "core/tool/span_rows.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr double unitsAVoxel = SpanRows::unitsAVoxel;
using Linear = TiltedPiece::Linear;
// Voxels around a rim's move within which the start of the move is checked as well: if the axis has turned since the
// start was cut, the rim may have been this far off.
constexpr double rimMargin = 0.25;
// If a line's point on a disc moves by less over the entire move, it counts as fixed: the move is parallel to the
// lines.
constexpr double leastRun = 1e-6; // voxels

/// Returns a linear function of x and y from its values.
template <class Function>
Linear linear(const Function& function) noexcept {
    const double origin = function(0.0, 0.0);
    return {origin, function(1.0, 0.0) - origin, function(0.0, 1.0) - origin};
}

/// Returns the value, kept away from 0: a plane parallel to the runs is met nowhere; a minimally inclined one gives the
/// same result.
double awayFromZero(double value, double scale) noexcept {
    const double least = 1e-7 * scale;
    return std::abs(value) >= least ? value : std::copysign(least, value);
}

/// Returns the height at which normal · (x, y, z) has a value.
Linear planeOf(const glm::dvec3& normal, double value) noexcept {
    const double along = awayFromZero(normal.z, glm::length(normal)) / unitsAVoxel;
    return linear([&](double x, double y) { return (value - normal.x * x - normal.y * y) / along; });
}

/// Restricts a cylinder to where normal · (x, y, z) lies between two values.
void setSlab(TiltedPiece::Cylinder& cylinder, const glm::dvec3& normal, double low, double high) noexcept {
    const double along = awayFromZero(normal.z, glm::length(normal)) / unitsAVoxel;
    cylinder.floor = planeOf(normal, along > 0.0 ? low : high);
    cylinder.thickness = static_cast<float>(std::abs((high - low) / along));
}

/// Returns the wall in terms of heights, for a move that is steep relative to the disc or a nearly horizontal axis.
TiltedPiece::Rim rimByHeight(const glm::dvec3& axis, const glm::dvec3& way, double height, double along,
                             double overlap) noexcept {
    TiltedPiece::Rim rim;
    const auto onFace = [&](double x, double y, double z) {
        const glm::dvec3 place = glm::dvec3(x, y, z) - height * axis;
        return place - way * (glm::dot(place, axis) / along);
    };
    const glm::dvec3 run = onFace(0.0, 0.0, 1.0) - onFace(0.0, 0.0, 0.0);
    const double length = glm::length(run);
    if (length < leastRun) return rim;
    const glm::dvec3 direction = run / length, across = glm::cross(axis, direction);
    rim.wall.interval = static_cast<float>(unitsAVoxel / length);
    rim.wall.aside = linear([&](double x, double y) { return glm::dot(onFace(x, y, 0.0), across); });
    rim.wall.middle =
        linear([&](double x, double y) { return -glm::dot(onFace(x, y, 0.0), direction) / length * unitsAVoxel; });
    const double more = overlap * std::abs(along);
    setSlab(rim.wall, axis, height + std::min(along, 0.0) - more, height + std::max(along, 0.0) + more);
    return rim;
}

/// Returns the wall in terms of parts of the move, from its middle: heights, which hardly differ if the move is nearly
/// in the plane of the disc, would not distinguish its points.
TiltedPiece::Rim rimByPart(const glm::dvec3& axis, const glm::dvec3& way, double height, double along,
                           double overlap) noexcept {
    TiltedPiece::Rim rim;
    const double rise = along / axis.z, sign = std::copysign(1.0, rise); // of a line's point on the disc, entire move
    const glm::dvec3 run = sign * (glm::dvec3(0.0, 0.0, rise) - way);
    const double length = glm::length(run);
    if (length < leastRun) return rim;
    const glm::dvec3 direction = run / length, across = glm::cross(axis, direction);
    const auto level = [&](double x, double y) { return (height + 0.5 * along - axis.x * x - axis.y * y) / axis.z; };
    const auto onDisc = [&](double x, double y) { return glm::dvec3(x, y, level(x, y)) - height * axis - 0.5 * way; };
    rim.wall.interval = static_cast<float>(1.0 / length);
    rim.wall.aside = linear([&](double x, double y) { return glm::dot(onDisc(x, y), across); });
    rim.wall.middle = linear([&](double x, double y) { return -glm::dot(onDisc(x, y), direction) / length; });
    rim.wall.floor.origin = -0.5 - overlap;
    rim.wall.thickness = static_cast<float>(1.0 + 2.0 * overlap);
    rim.lift = linear([&](double x, double y) { return level(x, y) * unitsAVoxel; });
    rim.scale = static_cast<float>(std::abs(rise) * unitsAVoxel);
    return rim;
}

/// Returns the wall of a disc about the axis, `height` above the tip, moved along the move. None if it is moved within
/// its own plane or along the lines: no line enters it between its ends. Both ends are overlapped, so that rounding
/// leaves no gap.
TiltedPiece::Rim rimOnWay(const glm::dvec3& axis, const glm::dvec3& way, double height, double radius,
                          double reach) noexcept {
    const double along = glm::dot(way, axis), length = glm::length(way);
    if (std::abs(along) < 1e-7) return {};
    const double rounding = SpanRows::outlineError * (reach + length);
    const double overlap = std::min(0.25 * rounding / std::abs(along), 3.0 * rounding / length);
    TiltedPiece::Rim rim = std::abs(along) <= std::abs(axis.z) ? rimByPart(axis, way, height, along, overlap)
                                                               : rimByHeight(axis, way, height, along, overlap);
    rim.wall.radius = static_cast<float>(radius);
    return rim;
}

void setEnd(TiltedPiece::End& end, const glm::dvec3& tip, double depth) noexcept {
    end.x = tip.x;
    end.y = tip.y;
    end.wholeX = static_cast<std::int32_t>(std::floor(std::clamp(tip.x, -1e9, 1e9)));
    end.wholeY = static_cast<std::int32_t>(std::floor(std::clamp(tip.y, -1e9, 1e9)));
    const double height = std::clamp(tip.z * unitsAVoxel, -1e9, 1e9), whole = std::floor(height);
    end.base = static_cast<std::int32_t>(whole - depth);
    end.middle = static_cast<float>(height - whole + depth + 0.5);
}

} // namespace

void setAxis(TiltedPiece& tilted, const RevolvedPiece& piece, const glm::dvec3& axis) noexcept {
    const double corner = piece.cornerRadius, radius = piece.bottomRadius;
    tilted.rounding = corner == 0.0      ? TiltedPiece::Rounding::none
                      : corner == radius ? TiltedPiece::Rounding::ball
                                         : TiltedPiece::Rounding::bullNose;
    const bool ball = tilted.rounding == TiltedPiece::Rounding::ball;
    tilted.radius = static_cast<float>(radius);
    tilted.flatRadius = static_cast<float>(radius - corner);
    tilted.cornerRadius = static_cast<float>(corner);
    const double foot = piece.bottom + (ball ? corner : 0.0);
    const glm::dvec3 middle = axis * (piece.bottom + corner);
    tilted.middleX = middle.x;
    tilted.middleY = middle.y;
    tilted.middleZ = static_cast<float>(middle.z * unitsAVoxel);
    tilted.middleHeight = static_cast<float>(piece.bottom + corner);
    tilted.topHeight = static_cast<float>(piece.top);
    tilted.axisX = static_cast<float>(axis.x);
    tilted.axisY = static_cast<float>(axis.y);
    tilted.axisZ = static_cast<float>(axis.z);
    tilted.nearlyLevel = std::abs(axis.z) < 1e-3;
    const double lean = std::hypot(axis.x, axis.y);
    const glm::dvec2 heading = lean > 1e-12 ? glm::dvec2(axis.x, axis.y) / lean : glm::dvec2(1.0, 0.0);
    const double sine = std::max(lean, 1e-6);
    TiltedPiece::Cylinder& standing = tilted.standing;
    standing.radius = tilted.radius;
    standing.interval = static_cast<float>(unitsAVoxel / sine);
    standing.aside = {0.0, -heading.y, heading.x};
    standing.middle = {0.0, heading.x * axis.z / sine * unitsAVoxel, heading.y * axis.z / sine * unitsAVoxel};
    setSlab(standing, axis, foot, piece.top);
    tilted.equator = planeOf(axis, foot);
    tilted.face = planeOf(axis, piece.top);
    tilted.rises = !std::signbit(axis.z);
    tilted.firstRim = tilted.rounding == TiltedPiece::Rounding::none ? 0 : 1;
}

void setWay(TiltedPiece& tilted, const RevolvedPiece& piece, const glm::dvec3& axis, const glm::dvec3& from,
            const glm::dvec3& to, double depth) noexcept {
    setEnd(tilted.from, from, depth);
    setEnd(tilted.to, to, depth);
    const glm::dvec3 way = to - from;
    const double farthest = std::hypot(std::max(std::abs(piece.bottom), piece.top), piece.bottomRadius);
    for (int i = tilted.firstRim; i < 2; ++i) {
        const double height = i == 0 ? piece.bottom : piece.top;
        TiltedPiece::Rim& rim = tilted.rims[static_cast<std::size_t>(i)];
        rim = rimOnWay(axis, way, height, piece.bottomRadius, farthest);
        rim.height = static_cast<float>(height);
    }
    // A point that is passed between the ends but covered at neither is passed by an edge: it lies within the sweep of
    // a rim, and its line meets the face's plane within `reach` of the rim.
    const double along = std::abs(glm::dot(way, axis)), across = glm::length(glm::cross(way, axis));
    const double steep = std::max(std::abs(axis.z), 1e-6), lean = std::hypot(axis.x, axis.y);
    const double reach = across + (along * lean + rimMargin) / steep;
    tilted.rimReach = static_cast<float>(reach * (2.0 * piece.bottomRadius + reach));
    // If the move passes the entire thickness, the part between the ends is nowhere within both.
    tilted.rimsEverywhere =
        reach > piece.bottomRadius || along + rimMargin > piece.top - piece.bottom - piece.cornerRadius;
}

} // namespace burin
