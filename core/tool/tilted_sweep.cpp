// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/tilted_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// A move inclined by less than this counts as parallel to the lines: what a line meets beyond both ends' chords then
// lies within 1e-7 of the move's length of a steep wall.
constexpr double leastSine = 1e-7;
constexpr double leastLength = 1e-12; // mm
// A wall's point within this distance of a line counts as lying on it. Lines of a grid and ends of moves lie on round
// numbers: a wall then begins or ends on a line, which the cutter at that end may touch and not cover.
constexpr double besideLine = 1e-10; // mm
// A line within this distance inside a side of the move still only touches it: the roots that give its length inside
// are rounding errors there. A side that is a face also contains lines within this distance outside of it, like
// PieceChord's faces: two pieces of a stack share it.
constexpr double besideSide = 1e-12; // mm
// Shorter spans count as empty: their ends are not known that accurately.
constexpr double leastSpan = 1e-9; // mm

glm::dvec3 in(const glm::dvec3& v, const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z) noexcept {
    return {glm::dot(v, x), glm::dot(v, y), glm::dot(v, z)};
}

/// Returns the point of a piece that lies farthest in a direction (unit length), mm from the tip.
glm::dvec3 farthest(const PieceProfile& profile, const glm::dvec3& axis, const glm::dvec3& direction) noexcept {
    const double sine = glm::dot(direction, axis);
    // Perpendicular to the axis even if very short, which the direction minus its axial component would not be.
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

/// Returns the height of the wall on a line, mm above the first tip, upside down for `side` -1; infinite if the wall's
/// point is not swept between the ends, nor within `besideLine` of the line from one of them.
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
        // A line that touches an end enters the solid there; a line in a side, or parallel to the move, keeps only
        // touching it.
        if (!chord || (chord->low == chord->high && !betweenSides)) continue;
        span.low = std::min(span.low, tip.z + chord->low);
        span.high = std::max(span.high, tip.z + chord->high);
    }
    if (betweenSides) {
        span.low = std::min(span.low, from_.z + wallAt(lower_, 1.0, x - from_.x, y - from_.y));
        span.high = std::max(span.high, from_.z - wallAt(upper_, -1.0, x - from_.x, y - from_.y));
    }
    if (!(span.high - span.low > leastSpan)) return std::nullopt; // infinite if an end is missing
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
