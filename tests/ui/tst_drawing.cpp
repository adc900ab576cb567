// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/test_program.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/scene/deviation_surface.h"
#include "ui/scene/frame_clock.h"
#include "ui/scene/path_thinner.h"
#include "ui/scene/round_spacing.h"
#include "ui/scene/shaded_mesh.h"

#include <QTest>

#include <rapidcheck.h>

#include <array>
#include <map>
#include <tuple>

namespace burin::tst_drawing {

namespace {

constexpr double crease = 25.0 * pi / 180.0;

TriangleMesh cube() {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) mesh.vertices.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

float distanceTo(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 way = b - a;
    const float length = glm::dot(way, way);
    const float share = length > 0.0F ? std::clamp(glm::dot(p - a, way) / length, 0.0F, 1.0F) : 0.0F;
    return glm::distance(p, a + way * share);
}

} // namespace

class TestDrawing : public QObject {
    Q_OBJECT

private slots:
    void aCubeKeepsItsEdges() {
        const ShadedMesh mesh = shaded(cube(), crease);
        QCOMPARE(mesh.points.size(), std::size_t{24});  // one point per corner and face
        QCOMPARE(mesh.creases.size(), std::size_t{24}); // twelve edges, no diagonal
        for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
            const glm::vec3 &a = mesh.points[mesh.triangles[i]], &b = mesh.points[mesh.triangles[i + 1]],
                            &c = mesh.points[mesh.triangles[i + 2]];
            const glm::vec3 flat = glm::normalize(glm::cross(b - a, c - a));
            for (std::size_t k = 0; k < 3; ++k)
                QVERIFY(glm::distance(mesh.normals[mesh.triangles[i + k]], flat) < 1e-6F);
        }
    }

    /// Two squares in one plane, shaded as one surface: where their colours differ, each has points of its own; the
    /// shading stays the same.
    void coloursDivideASmoothSurface() {
        TriangleMesh mesh;
        mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}};
        mesh.triangles = {{0, 0, 1}, {0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}}; // the first has no area
        QCOMPARE(shaded(mesh, crease).points.size(), std::size_t{6});
        const ShadedMesh two = shaded(mesh, crease, {{3, 2, {10, 20, 30}}});
        QCOMPARE(two.points.size(), std::size_t{8}); // the edge between the squares is there twice
        QCOMPARE(two.colours.size(), two.points.size());
        QVERIFY(two.creases.empty() == shaded(mesh, crease).creases.empty());
        for (std::size_t i = 0; i < two.triangles.size(); ++i) {
            const std::array<std::uint8_t, 4> expected =
                i < 6 ? std::array<std::uint8_t, 4>{} : std::array<std::uint8_t, 4>{10, 20, 30, 255};
            QVERIFY(two.colours[two.triangles[i]] == expected);
        }
    }

    /// A surface that was divided for the deviation map has no long edge and no gap, and its position is unchanged.
    void aDividedSurfaceIsClosedAndFine() {
        const ShadedMesh mesh = divided(shaded(fixture::dome({24.0, 16.0, 14.0}, 9, 4), crease), 1.5);
        std::map<std::array<float, 6>, int> sides; // of an edge's ends: the two directions cancel each other
        double volume = 0.0;
        for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::vec3 &a = mesh.points[mesh.triangles[i + k]],
                                &b = mesh.points[mesh.triangles[i + (k + 1) % 3]];
                QVERIFY(glm::distance(a, b) <= 1.5001F);
                const bool forward = std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
                const glm::vec3 &low = forward ? a : b, &high = forward ? b : a;
                sides[{low.x, low.y, low.z, high.x, high.y, high.z}] += forward ? 1 : -1;
            }
            const glm::dvec3 a = mesh.points[mesh.triangles[i]], b = mesh.points[mesh.triangles[i + 1]],
                             c = mesh.points[mesh.triangles[i + 2]];
            volume += glm::dot(a, glm::cross(b, c)) / 6.0;
        }
        for (const auto& [edge, balance] : sides) QCOMPARE(balance, 0);
        const TriangleMesh whole = fixture::dome({24.0, 16.0, 14.0}, 9, 4);
        double expected = 0.0;
        for (const auto& [a, b, c] : whole.triangles)
            expected += glm::dot(whole.vertices[a], glm::cross(whole.vertices[b], whole.vertices[c])) / 6.0;
        QVERIFY(std::abs(volume - expected) < 1e-4 * expected);
    }

    void aDomeIsSmoothButForItsFoot() {
        const glm::dvec3 radii(24.0, 16.0, 14.0);
        const ShadedMesh mesh = shaded(fixture::dome(radii), crease);
        for (std::size_t i = 0; i < mesh.points.size(); ++i) {
            const glm::dvec3 place(mesh.points[i]), normal(mesh.normals[i]);
            if (place.z < 1e-9) continue;                                               // the foot of the dome
            QVERIFY(glm::dot(normal, glm::normalize(place / (radii * radii))) > 0.995); // the ellipsoid's own normal
        }
        QCOMPARE(mesh.creases.size(), std::size_t{2 * 72}); // only the edge of the foot
    }

    void aRayMeetsTheNearestTriangle() {
        const ShadedMesh mesh = shaded(cube(), crease);
        QCOMPARE(distanceAlong(mesh, {0.3, 0.4, 5.0}, {0.0, 0.0, -1.0}).value(), 4.0);
        QVERIFY(!distanceAlong(mesh, {0.3, 0.4, 5.0}, {0.0, 0.0, 1.0}));
        QVERIFY(!distanceAlong(mesh, {1.3, 0.4, 5.0}, {0.0, 0.0, -1.0}));
    }

    /// The drawn line passes within the tolerance of every point that it leaves out, and ends where the path does.
    void thinningKeepsThePathWithinItsTolerance() {
        constexpr float tolerance = 0.01F;
        QVERIFY(rc::check([] {
            std::vector<glm::vec3> path{glm::vec3(0.0F)};
            for (const int turn : *rc::gen::container<std::vector<int>>(rc::gen::inRange(-40, 41))) {
                const float angle = static_cast<float>(turn) * 0.02F * static_cast<float>(path.size() % 7);
                path.push_back(path.back() +
                               0.06F * glm::vec3(std::cos(angle), std::sin(angle), 0.1F * std::sin(angle)));
            }
            PathThinner thinner(tolerance);
            thinner.begin(path[0]);
            std::vector<std::size_t> kept{0};
            for (std::size_t i = 1; i < path.size(); ++i) {
                if (thinner.add(path[i])) kept.push_back(i);
                kept.back() = i;
            }
            RC_ASSERT(kept.back() == path.size() - 1);
            for (std::size_t k = 1; k < kept.size(); ++k)
                for (std::size_t i = kept[k - 1]; i <= kept[k]; ++i)
                    RC_ASSERT(distanceTo(path[i], path[kept[k - 1]], path[kept[k]]) <= tolerance * 1.001F);
        }));
    }

    void aStraightPathNeedsFewPoints() {
        PathThinner thinner(0.01F);
        thinner.begin(glm::vec3(0.0F));
        int corners = 0;
        for (int i = 1; i <= 1000; ++i)
            if (thinner.add({0.05F * static_cast<float>(i), 0.0F, 0.0F})) ++corners;
        QVERIFY(corners < 40);
    }

    void spacingsAreRound() {
        QCOMPARE(roundSpacing(100.0), 10.0);
        QCOMPARE(roundSpacing(180.0), 20.0);
        QCOMPARE(roundSpacing(4.0), 0.5);
        QCOMPARE(roundSpacing(0.09), 0.01);
    }

    void theFrameClockGivesTheSlowestTwentieth() {
        using namespace std::chrono_literals;
        FrameClock clock;
        const FrameClock::Clock::time_point start{};
        for (int i = 1; i <= 100; ++i)
            clock.add(start, start + i * 1ms, i % 2 == 0 ? std::optional(start - 10ms) : std::nullopt);
        const FrameStatistics statistics = clock.statistics();
        QCOMPARE(statistics.frames, std::size_t{100});
        QCOMPARE(statistics.paintP95, 95.0);
        QCOMPARE(statistics.paintMaximum, 100.0);
        QCOMPARE(statistics.cutsShown, std::size_t{50});
        QCOMPARE(statistics.cutToScreenP95, 106.0); // the 48th of the even values
        QCOMPARE(statistics.cutToScreenMaximum, 110.0);
        clock.reset();
        QCOMPARE(clock.statistics().frames, std::size_t{0});
    }
};

BURIN_TEST(TestDrawing, NoApplication)

} // namespace burin::tst_drawing

#include "tst_drawing.moc"
