// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/tilted_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Less lean than this counts as a way along the lines: what a line meets beyond both ends' chords then lies within
// 1e-7 of the move's length of a steep wall.
constexpr double leastSine = 1e-7;
constexpr double leastLength = 1e-12; // mm
// So far beside a line a wall's point still counts as on it. Lines of a grid and ends of ways lie on round numbers:
// a wall then begins or ends on a line, which the cutter at that end may touch and not cover.
constexpr double besideLine = 1e-10; // mm
// So far inside of a side of the way a line still touches it: the roots that tell how much of it is inside are
// roundings there. A side that is a face holds the lines as far outside of it, as PieceChord's faces do: two pieces of
// a stack share it.
constexpr double besideSide = 1e-12; // mm
// Shorter spans are nothing: their ends are not known that well.
constexpr double leastSpan = 1e-9; // mm

glm::dvec3 in(const glm::dvec3& v, const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z) noexcept {
    return {glm::dot(v, x), glm::dot(v, y), glm::dot(v, z)};
}

/// The point of a piece that lies farthest in a direction (unit length), mm from the tip.
glm::dvec3 farthest(const PieceProfile& profile, const glm::dvec3& axis, const glm::dvec3& direction) noexcept {
    const double sine = glm::dot(direction, axis);
    // Square to the axis however short it is, which the difference to the part along the axis would not be.
    const glm::dvec3 outward = glm::cross(axis, glm::cross(direction, axis));
    const double cosine = glm::length(outward);
    const ProfileDisc place = profile.farthest(sine, cosine);
    return place.height * axis + (cosine > 0.0 ? place.radius / cosine : 0.0) * outward;
}

Box boundsAt(const PieceProfile& profile, const glm::dvec3& axis) noexcept {
    Box box;
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 direction(0.0);
        direction[i] = 1.0;
        box.high[i] = farthest(profile, axis, direction)[i];
        box.low[i] = farthest(profile, axis, -direction)[i];
    }
    return box;
}

} // namespace

TiltedSweep::View TiltedSweep::viewAlong(const glm::dvec3& way) noexcept {
    const double length = glm::length(way);
    if (!(length > leastLength)) return {};
    View view;
    view.depth = way / length;
    const double sine = std::hypot(view.depth.x, view.depth.y);
    if (!(sine > leastSine)) return {};
    view.across = glm::dvec3(-view.depth.y, view.depth.x, 0.0) / sine;
    view.up = glm::cross(view.depth, view.across);
    return view;
}

TiltedSweep::TiltedSweep(const RevolvedPiece& piece, const glm::dvec3& fromTip, const glm::dvec3& toTip,
                         const glm::dvec3& axis) noexcept
    : from_(fromTip)
    , to_(toTip)
    , chord_(piece, axis)
    , view_(viewAlong(toTip - fromTip))
    , length_(glm::length(toTip - fromTip))
    , sine_(std::hypot(view_.depth.x, view_.depth.y))
    , leavesWall_(length_ > leastLength && sine_ > leastSine)
    , lower_(PieceProfile(piece), in(axis, view_.across, view_.up, view_.depth))
    , upper_(PieceProfile(piece), in(axis, view_.across, -view_.up, -view_.depth))
    , left_(PieceProfile(piece), {axis.y, axis.x, -axis.z})
    , right_(PieceProfile(piece), {axis.y, -axis.x, axis.z}) {
    const PieceProfile profile(piece);
    const Box box = boundsAt(profile, axis);
    bounds_ = {glm::min(from_, to_) + box.low, glm::max(from_, to_) + box.high};
    const glm::dvec2 way(to_.x - from_.x, to_.y - from_.y);
    const double reach = std::hypot(way.x, way.y);
    if (!(reach > 0.0)) return;
    for (std::size_t i = 0; i < tangents_.size(); ++i)
        tangents_[i] = farthest(profile, axis, glm::dvec3(-way.y, way.x, 0.0) * ((i == 0 ? 1.0 : -1.0) / reach));
    const bool areFaces = glm::length(glm::cross(axis, view_.across)) <= besideSide;
    const double outward = areFaces ? besideSide : -besideSide;
    sides_ = {glm::dot(tangents_[1], glm::dvec2(view_.across)) - outward,
              glm::dot(tangents_[0], glm::dvec2(view_.across)) + outward};
}

/// Height of the wall on a line, mm above the first tip, with `side` -1 upside down; infinite where the wall's point
/// is not thrown between the ends, or to `besideLine` of the line from one of them.
double TiltedSweep::wallAt(const ShadowEdge& edge, double side, double x, double y) const noexcept {
    const glm::dvec3 place(x, y, 0.0);
    const ShadowEdge::Point point = edge.lowest(glm::dot(place, view_.across));
    if (!(point.up < infinity)) return infinity;
    const double height = (point.up - side * glm::dot(place, view_.up)) / sine_;
    const double way = glm::dot(place, view_.depth) + side * (height * view_.depth.z - point.depth); // mm, of its point
    const double beyond = way - std::clamp(way, 0.0, length_);
    return std::abs(beyond) * sine_ <= besideLine ? height - side * beyond * view_.depth.z : infinity;
}

bool TiltedSweep::isBetweenSides(double x, double y) const noexcept {
    const double across = glm::dot(glm::dvec2(x - from_.x, y - from_.y), glm::dvec2(view_.across));
    return across > sides_.low && across < sides_.high;
}

std::optional<Span> TiltedSweep::along(double x, double y) const noexcept {
    const bool betweenSides = leavesWall_ && isBetweenSides(x, y);
    Span span{infinity, -infinity};
    for (const glm::dvec3& tip : {from_, to_}) {
        const std::optional<Span> chord = chord_.along(x - tip.x, y - tip.y);
        // A line that touches an end enters the solid there; one in a side, or along the move, only touches it on.
        if (!chord || (chord->low == chord->high && !betweenSides)) continue;
        span.low = std::min(span.low, tip.z + chord->low);
        span.high = std::max(span.high, tip.z + chord->high);
    }
    if (betweenSides) {
        span.low = std::min(span.low, from_.z + wallAt(lower_, 1.0, x - from_.x, y - from_.y));
        span.high = std::max(span.high, from_.z - wallAt(upper_, -1.0, x - from_.x, y - from_.y));
    }
    if (!(span.high - span.low > leastSpan)) return std::nullopt; // infinite where an end is missing
    return span;
}

std::optional<Span> TiltedSweep::shadow(double y) const noexcept {
    Span shadow{infinity, -infinity};
    for (const glm::dvec3& tip : {from_, to_}) {
        shadow.low = std::min(shadow.low, tip.x + left_.lowest(y - tip.y).up);
        shadow.high = std::max(shadow.high, tip.x - right_.lowest(y - tip.y).up);
    }
    const double rise = to_.y - from_.y;
    if (rise != 0.0) {
        for (const glm::dvec2& tangent : tangents_) { // the straight sides between the ends
            const double part = (y - (from_.y + tangent.y)) / rise;
            if (!(part >= 0.0 && part <= 1.0)) continue;
            const double x = from_.x + tangent.x + part * (to_.x - from_.x);
            shadow.low = std::min(shadow.low, x);
            shadow.high = std::max(shadow.high, x);
        }
    }
    if (!(shadow.low < shadow.high)) return std::nullopt;
    return shadow;
}

} // namespace burin
