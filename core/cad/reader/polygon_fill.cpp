// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/polygon_fill.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace burin {

namespace {

using Loop = std::vector<PolygonCorner>;

/// Returns twice the area of a triangle; positive if it is counter-clockwise.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether a point lies in a triangle, at least `depth` mm from its sides.
bool isInside(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, double depth) {
    return turn(a, b, p) >= depth * glm::distance(a, b) && turn(b, c, p) >= depth * glm::distance(b, c) &&
           turn(c, a, p) >= depth * glm::distance(c, a);
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

/// Joins a hole to the loop by a cut and its reverse, between the nearest corners that are visible from each other.
void joinHole(Loop& loop, const Loop& hole) {
    struct Bridge {
        double length = 0.0;
        std::size_t outer = 0, inner = 0;
    };
    // The hole's rightmost corner always sees a corner of the loop; if rounding prevents it, the nearest one is used.
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

/// @param tolerance mm by which other corners may reach into the ear, or the ear may be inverted: where loops cross
/// slightly, this amount must be tolerated.
bool isEar(const Loop& loop, std::size_t i, double tolerance) {
    const std::size_t n = loop.size();
    const PolygonCorner &a = loop[(i + n - 1) % n], &b = loop[i], &c = loop[(i + 1) % n];
    const double turned = turn(a.place, b.place, c.place);
    if (turned <= 0.0 && (tolerance == 0.0 || turned < -tolerance * glm::distance(a.place, c.place))) return false;
    return std::none_of(loop.begin(), loop.end(), [&](const PolygonCorner& p) {
        return p.place != a.place && p.place != b.place && p.place != c.place &&
               isInside(p.place, a.place, b.place, c.place, tolerance);
    });
}

/// Returns the quality of the triangle at a corner: area over the square of its longest side.
double shape(const Loop& loop, std::size_t i) {
    const std::size_t n = loop.size();
    const glm::dvec2 &a = loop[(i + n - 1) % n].place, &b = loop[i].place, &c = loop[(i + 1) % n].place;
    const double longest = std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
    return longest > 0.0 ? turn(a, b, c) / longest : 0.0;
}

/// The best-shaped ear, or the first good one.
std::optional<std::size_t> findEar(const Loop& loop, double tolerance) {
    constexpr double good = 0.2;
    std::optional<std::size_t> best;
    double bestShape = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const double quality = shape(loop, i);
        if (quality <= bestShape || !isEar(loop, i, tolerance)) continue;
        bestShape = quality;
        best = i;
        if (quality > good) break;
    }
    return best;
}

/// Returns the ear to clip next. Where loops touch or cross there may be none without a tolerance; if no tolerance
/// suffices, returns the flattest corner.
std::size_t nextEar(const Loop& loop) {
    for (const double tolerance : {0.0, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1}) // mm
        if (const std::optional<std::size_t> ear = findEar(loop, tolerance)) return *ear;
    std::size_t flattest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < loop.size(); ++i)
        if (const double quality = std::abs(shape(loop, i)); quality < least) {
            least = quality;
            flattest = i;
        }
    return flattest;
}

/// The corners between two edges of the loop that cross each other, as first and count, in the shorter direction.
struct Lobe {
    std::size_t first = 0, count = 0;
};

std::optional<Lobe> findLobe(const Loop& loop) {
    constexpr std::size_t most = 12; // corners; a tip of two rounded edges that run into each other has a few
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t steps = 2; steps <= most && steps + 2 < n; ++steps) {
            const PolygonCorner &a = loop[i], &b = loop[(i + 1) % n], &c = loop[(i + steps) % n],
                                &d = loop[(i + steps + 1) % n];
            const bool touches = a.place == c.place || a.place == d.place || b.place == c.place || b.place == d.place;
            if (!touches && crosses(a.place, b.place, c.place, d.place)) return Lobe{(i + 1) % n, steps};
        }
    return std::nullopt;
}

/// Clips the lobes where a loop crosses itself locally, before any other ear: where two edges of a face meet in a sharp
/// tip, their approximation by chords makes them cross by a ten-thousandth of a millimetre, and the ears of such a loop
/// would overlap across the whole face.
template <class Clip>
void untangle(Loop& loop, Clip clip) {
    for (std::optional<Lobe> lobe = findLobe(loop); lobe && loop.size() > 3; lobe = findLobe(loop))
        for (std::size_t i = 0; i < lobe->count && loop.size() > 3; ++i)
            clip(loop, lobe->first < loop.size() ? lobe->first : 0);
}

} // namespace

std::vector<std::array<std::uint32_t, 3>> fillPolygon(std::vector<Loop> loops) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    if (loops.empty()) return triangles;
    // At the end of a bridge a corner may lie between two copies of the same vertex: its triangle is empty.
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    };
    const auto clip = [&](Loop& from, std::size_t ear) {
        const std::size_t n = from.size();
        add(from[(ear + n - 1) % n].vertex, from[ear].vertex, from[(ear + 1) % n].vertex);
        from.erase(from.begin() + static_cast<std::ptrdiff_t>(ear));
    };
    for (Loop& each : loops) untangle(each, clip);
    Loop loop = std::move(loops.front());
    const auto rightmost = [](const Loop& hole) {
        double x = -std::numeric_limits<double>::infinity();
        for (const PolygonCorner& corner : hole) x = std::max(x, corner.place.x);
        return x;
    };
    std::sort(loops.begin() + 1, loops.end(),
              [&](const Loop& a, const Loop& b) { return rightmost(a) > rightmost(b); });
    for (std::size_t hole = 1; hole < loops.size(); ++hole) joinHole(loop, loops[hole]);
    while (loop.size() > 3) clip(loop, nextEar(loop));
    if (loop.size() == 3) add(loop[0].vertex, loop[1].vertex, loop[2].vertex);
    return triangles;
}

} // namespace burin
