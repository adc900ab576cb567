// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/tilted_shadow.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

// A disc that is seen nearly edge-on counts as this wide: its shadow contains the true one.
constexpr double leastFlatness = 1e-3;

struct End {
    TiltedShadow::Ellipse ellipse;
    glm::dvec2 middle, reach;
    double outmost; ///< dy of its outermost point towards +x
};

End endOf(const glm::dvec2& middle, const glm::dvec2& heading, double radius, double flatness) noexcept {
    const glm::dvec2 across = radius * glm::dvec2(-heading.y, heading.x), along = radius * flatness * heading;
    const double xx = across.x * across.x + along.x * along.x, yy = across.y * across.y + along.y * along.y;
    const double xy = across.x * across.y + along.x * along.y;
    End end;
    end.middle = middle;
    end.reach = {std::sqrt(xx), std::sqrt(yy)};
    end.outmost = xy / end.reach.x;
    end.ellipse.middle = glm::vec2(middle);
    end.ellipse.slope = static_cast<float>(xy / yy);
    end.ellipse.half = static_cast<float>(radius * radius * flatness / end.reach.y);
    end.ellipse.perSquare = static_cast<float>(1.0 / yy);
    return end;
}

} // namespace

TiltedShadow shadowOf(const RevolvedPiece& piece, const glm::dvec3& axis) noexcept {
    const double radius = piece.bottomRadius, lean = std::hypot(axis.x, axis.y);
    const glm::dvec2 heading = lean > 0.0 ? glm::dvec2(axis) / lean : glm::dvec2(1.0, 0.0);
    const double flatness = std::max(std::abs(axis.z), leastFlatness);
    const bool ball = piece.cornerRadius == radius;
    const double foot = piece.bottom + (ball ? piece.cornerRadius : 0.0);
    const std::array ends{endOf(foot * glm::dvec2(axis), heading, radius, ball ? 1.0 : flatness),
                          endOf(piece.top * glm::dvec2(axis), heading, radius, flatness)};
    TiltedShadow shadow;
    shadow.ends = {ends[0].ellipse, ends[1].ellipse};
    shadow.contact = glm::vec2(radius * glm::dvec2(-heading.y, heading.x));
    shadow.low = glm::min(ends[0].middle - ends[0].reach, ends[1].middle - ends[1].reach);
    shadow.high = glm::max(ends[0].middle + ends[0].reach, ends[1].middle + ends[1].reach);
    for (const int i : {0, 1}) {
        const double side = i == 0 ? -1.0 : 1.0;
        const auto farthest = [&](const End& end) { return side * end.middle.x + end.reach.x; };
        const End& end = farthest(ends[0]) > farthest(ends[1]) ? ends[0] : ends[1];
        shadow.outmost[static_cast<std::size_t>(i)] = static_cast<float>(end.middle.y + side * end.outmost);
    }
    return shadow;
}

} // namespace burin
