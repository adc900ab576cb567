// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/polygon_fill.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace burin {

namespace {

using Loop = std::vector<PolygonCorner>;

/// Twice the area of a triangle; positive when it turns counter-clockwise.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool isInside(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
}

bool crosses(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
    const bool cApart = (turn(a, b, c) > 0.0) != (turn(a, b, d) > 0.0);
    const bool aApart = (turn(c, d, a) > 0.0) != (turn(c, d, b) > 0.0);
    return cApart && aApart;
}

bool isFree(const Loop& loop, const glm::dvec2& from, const glm::dvec2& to) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const glm::dvec2& a = loop[i].place;
        const glm::dvec2& b = loop[(i + 1) % loop.size()].place;
        if (a == from || b == from || a == to || b == to) continue;
        if (crosses(from, to, a, b)) return false;
    }
    return true;
}

/// Joins a hole to the loop by a cut that runs there and back, between the nearest corners that see each other.
void joinHole(Loop& loop, const Loop& hole) {
    struct Bridge {
        double length = 0.0;
        std::size_t outer = 0, inner = 0;
    };
    // The hole's rightmost corner always sees something of the loop; when rounding denies it, the nearest one serves.
    std::vector<Bridge> bridges;
    const auto rightmost = std::max_element(
        hole.begin(), hole.end(), [](const PolygonCorner& a, const PolygonCorner& b) { return a.place.x < b.place.x; });
    const auto inner = static_cast<std::size_t>(rightmost - hole.begin());
    for (std::size_t outer = 0; outer < loop.size(); ++outer)
        bridges.push_back({glm::distance(loop[outer].place, rightmost->place), outer, inner});
    std::sort(bridges.begin(), bridges.end(), [](const Bridge& a, const Bridge& b) { return a.length < b.length; });
    const auto seen = std::find_if(bridges.begin(), bridges.end(), [&](const Bridge& bridge) {
        return isFree(loop, loop[bridge.outer].place, rightmost->place) &&
               isFree(hole, loop[bridge.outer].place, rightmost->place);
    });
    const Bridge bridge = seen == bridges.end() ? bridges.front() : *seen;
    Loop insert;
    for (std::size_t i = 0; i <= hole.size(); ++i) insert.push_back(hole[(bridge.inner + i) % hole.size()]);
    insert.push_back(loop[bridge.outer]);
    loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(bridge.outer) + 1, insert.begin(), insert.end());
}

bool isEar(const Loop& loop, std::size_t i) {
    const std::size_t n = loop.size();
    const PolygonCorner &a = loop[(i + n - 1) % n], &b = loop[i], &c = loop[(i + 1) % n];
    if (turn(a.place, b.place, c.place) <= 0.0) return false;
    return std::none_of(loop.begin(), loop.end(), [&](const PolygonCorner& p) {
        return p.place != a.place && p.place != b.place && p.place != c.place &&
               isInside(p.place, a.place, b.place, c.place);
    });
}

/// How well-shaped the triangle at a corner is: area over the square of its longest side.
double shape(const Loop& loop, std::size_t i) {
    const std::size_t n = loop.size();
    const glm::dvec2 &a = loop[(i + n - 1) % n].place, &b = loop[i].place, &c = loop[(i + 1) % n].place;
    const double longest = std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
    return longest > 0.0 ? turn(a, b, c) / longest : 0.0;
}

/// The ear to clip next. Where loops touch or cross there may be none: then the corner that turns least the wrong way.
std::size_t nextEar(const Loop& loop) {
    constexpr double good = 0.2;
    std::optional<std::size_t> best;
    std::size_t least = 0;
    double bestShape = 0.0, leastHarm = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const double quality = shape(loop, i);
        if (std::abs(quality) < leastHarm) {
            leastHarm = std::abs(quality);
            least = i;
        }
        if (quality <= bestShape || !isEar(loop, i)) continue;
        bestShape = quality;
        best = i;
        if (quality > good) break;
    }
    return best.value_or(least);
}

} // namespace

std::vector<std::array<std::uint32_t, 3>> fillPolygon(std::vector<Loop> loops) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    if (loops.empty()) return triangles;
    Loop loop = std::move(loops.front());
    const auto rightmost = [](const Loop& hole) {
        double x = -std::numeric_limits<double>::infinity();
        for (const PolygonCorner& corner : hole) x = std::max(x, corner.place.x);
        return x;
    };
    std::sort(loops.begin() + 1, loops.end(),
              [&](const Loop& a, const Loop& b) { return rightmost(a) > rightmost(b); });
    for (std::size_t hole = 1; hole < loops.size(); ++hole) joinHole(loop, loops[hole]);
    // At the end of a bridge a corner may lie between twice the same vertex: nothing is left to cover there.
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    };
    while (loop.size() > 3) {
        const std::size_t ear = nextEar(loop), n = loop.size();
        add(loop[(ear + n - 1) % n].vertex, loop[ear].vertex, loop[(ear + 1) % n].vertex);
        loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    if (loop.size() == 3) add(loop[0].vertex, loop[1].vertex, loop[2].vertex);
    return triangles;
}

} // namespace burin
