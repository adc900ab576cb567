// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/reader/polygon_fill.h"
#include "core/geometry/triangle_mesh.h"
#include "tests/test_program.h"

#include <QtTest>

#include <cmath>
#include <map>
#include <rapidcheck.h>

namespace burin::tst_polygon_fill {

namespace {

using Loop = std::vector<PolygonCorner>;

Loop ring(std::uint32_t first, int count, glm::dvec2 centre, double radius, double roughness, bool clockwise) {
    Loop loop;
    for (int i = 0; i < count; ++i) {
        const double angle = (clockwise ? -1.0 : 1.0) * 2.0 * M_PI * i / count;
        const double r = radius * (1.0 + roughness * std::sin(7.0 * angle) * std::cos(3.0 * angle));
        loop.push_back(
            {centre + r * glm::dvec2(std::cos(angle), std::sin(angle)), first + static_cast<std::uint32_t>(i)});
    }
    return loop;
}

double area(const Loop& loop) {
    double twice = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const glm::dvec2 &a = loop[i].place, &b = loop[(i + 1) % loop.size()].place;
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * twice;
}

/// Number of uses of each directed edge by the triangles, minus those of the opposite direction: exactly the loops'
/// edges remain.
bool boundsTheLoops(const std::vector<std::array<std::uint32_t, 3>>& triangles, const std::vector<Loop>& loops) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
    const auto use = [&](std::uint32_t from, std::uint32_t to, int times) {
        if (from < to)
            balance[{from, to}] += times;
        else
            balance[{to, from}] -= times;
    };
    for (const auto& t : triangles)
        for (std::size_t i = 0; i < 3; ++i) use(t[i], t[(i + 1) % 3], 1);
    for (const Loop& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) use(loop[i].vertex, loop[(i + 1) % loop.size()].vertex, -1);
    return std::all_of(balance.begin(), balance.end(), [](const auto& entry) { return entry.second == 0; });
}

double areaOf(const std::vector<std::array<std::uint32_t, 3>>& triangles, const std::vector<Loop>& loops,
              bool absolute) {
    std::map<std::uint32_t, glm::dvec2> places;
    for (const Loop& loop : loops)
        for (const PolygonCorner& corner : loop) places[corner.vertex] = corner.place;
    double sum = 0.0;
    for (const auto& [a, b, c] : triangles) {
        const glm::dvec2 u = places[b] - places[a], v = places[c] - places[a];
        const double part = 0.5 * (u.x * v.y - u.y * v.x);
        sum += absolute ? std::abs(part) : part;
    }
    return sum;
}

} // namespace

class PolygonFill : public QObject {
    Q_OBJECT

private slots:
    void fillsExactlyThePolygonWithHoles() {
        QVERIFY(rc::check("triangles cover the polygon once and end at its loops", [] {
            const int count = *rc::gen::inRange(3, 60), holes = *rc::gen::inRange(0, 5);
            const double roughness = *rc::gen::inRange(0, 30) / 100.0;
            std::vector<Loop> loops{ring(0, std::max(count, 12), {0.0, 0.0}, 10.0, roughness, false)};
            double expected = area(loops[0]);
            for (int hole = 0; hole < holes; ++hole) {
                const double angle = 2.0 * M_PI * hole / 5.0 + 0.3;
                loops.push_back(ring(1000U * static_cast<std::uint32_t>(hole + 1), *rc::gen::inRange(3, 30),
                                     4.0 * glm::dvec2(std::cos(angle), std::sin(angle)), 1.5, 0.2, true));
                expected += area(loops.back());
            }
            const auto triangles = fillPolygon(loops);
            RC_ASSERT(boundsTheLoops(triangles, loops));
            RC_ASSERT(std::abs(areaOf(triangles, loops, true) - expected) < 1e-9 * expected);
        }));
    }
    void closesWhereTheLoopCrossesItself() {
        QVERIFY(rc::check("whatever the shape, each edge of the loop is used once", [] {
            Loop loop;
            const auto count = *rc::gen::inRange<std::uint32_t>(3, 40);
            for (std::uint32_t i = 0; i < count; ++i)
                loop.push_back({{*rc::gen::inRange(-20, 20), *rc::gen::inRange(-20, 20)}, i});
            const auto triangles = fillPolygon({loop});
            RC_ASSERT(triangles.size() == loop.size() - 2);
            RC_ASSERT(boundsTheLoops(triangles, {loop}));
            RC_ASSERT(std::abs(areaOf(triangles, {loop}, false) - area(loop)) < 1e-9);
        }));
    }
};

BURIN_TEST(PolygonFill, NoApplication)

} // namespace burin::tst_polygon_fill

#include "tst_polygon_fill.moc"
