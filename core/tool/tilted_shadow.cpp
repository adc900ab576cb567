// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/tilted_shadow.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

// A disc that is seen from nearly the side counts as this wide: its shadow holds the true one.
constexpr double leastFlatness = 1e-3;
constexpr double rounding = 1e-9;

} // namespace

TiltedShadow::Ellipse TiltedShadow::ellipse(const glm::dvec2& middle, const glm::dvec2& heading, double radius,
                                            double flatness) const noexcept {
    const glm::dvec2 across = radius * glm::dvec2(-heading.y, heading.x), along = radius * flatness * heading;
    const double xx = across.x * across.x + along.x * along.x, yy = across.y * across.y + along.y * along.y;
    const double xy = across.x * across.y + along.x * along.y;
    Ellipse ellipse;
    ellipse.middle = middle;
    ellipse.slope = xy / yy;
    ellipse.half = radius * radius * flatness / std::sqrt(yy);
    ellipse.perSquare = 1.0 / yy;
    ellipse.reach = {std::sqrt(xx), std::sqrt(yy)};
    ellipse.outmost = xy / ellipse.reach.x;
    return ellipse;
}

TiltedShadow::TiltedShadow(const RevolvedPiece& piece, const glm::dvec3& axis, const glm::dvec2& tip,
                           double margin) noexcept
    : margin_(margin) {
    const double radius = piece.bottomRadius, lean = std::hypot(axis.x, axis.y);
    const glm::dvec2 heading = lean > 0.0 ? glm::dvec2(axis) / lean : glm::dvec2(1.0, 0.0);
    const double flatness = std::max(std::abs(axis.z), leastFlatness);
    const bool ball = piece.cornerRadius == radius;
    const double foot = piece.bottom + (ball ? piece.cornerRadius : 0.0);
    ends_ = {ellipse(tip + foot * glm::dvec2(axis), heading, radius, ball ? 1.0 : flatness),
             ellipse(tip + piece.top * glm::dvec2(axis), heading, radius, flatness)};
    contact_ = radius * glm::dvec2(-heading.y, heading.x);
    low_ = glm::min(ends_[0].middle - ends_[0].reach, ends_[1].middle - ends_[1].reach) - margin;
    high_ = glm::max(ends_[0].middle + ends_[0].reach, ends_[1].middle + ends_[1].reach) + margin;
    for (const int i : {0, 1}) {
        const double side = i == 0 ? -1.0 : 1.0;
        const auto farthest = [&](const Ellipse& end) { return side * end.middle.x + end.reach.x; };
        const Ellipse& end = farthest(ends_[0]) > farthest(ends_[1]) ? ends_[0] : ends_[1];
        outmost_[static_cast<std::size_t>(i)] = end.middle.y + side * end.outmost;
    }
}

/// side · x of the outmost place at this y, without the margin.
double TiltedShadow::edge(double y, double side) const noexcept {
    double most = -std::numeric_limits<double>::infinity();
    for (const Ellipse& end : ends_) {
        const double dy = y - end.middle.y, square = 1.0 - dy * dy * end.perSquare;
        if (square < -rounding) continue;
        most = std::max(most, side * (end.middle.x + end.slope * dy) + end.half * std::sqrt(std::max(square, 0.0)));
    }
    const glm::dvec2 axis = ends_[1].middle - ends_[0].middle;
    if (std::abs(axis.y) < 1e-12) return most; // the ends say it all
    for (const double sign : {-1.0, 1.0}) {
        const glm::dvec2 from = ends_[0].middle + sign * contact_;
        const double part = (y - from.y) / axis.y;
        if (part >= 0.0 && part <= 1.0) most = std::max(most, side * (from.x + part * axis.x));
    }
    return most;
}

TiltedShadow::Stretch TiltedShadow::row(double y) const noexcept {
    if (!(y >= low_.y && y <= high_.y)) return {};
    // The outmost place of all that lies within the margin of this row: the edge is convex.
    const auto nearest = [&](double outmost) {
        return std::clamp(std::clamp(outmost, y - margin_, y + margin_), low_.y + margin_, high_.y - margin_);
    };
    return {-edge(nearest(outmost_[0]), -1.0) - margin_, edge(nearest(outmost_[1]), 1.0) + margin_};
}

} // namespace burin
