// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "path_fixture.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QTest>

#include <random>

namespace burin::tst_hold_out {

using namespace burin::test;

namespace {

constexpr double step = 0.02; // mm between the points that are checked

double boxDistance(const Box& box, const glm::dvec3& point) {
    const glm::dvec3 outside = glm::max(glm::max(box.low - point, point - box.high), glm::dvec3(0.0));
    if (outside != glm::dvec3(0.0)) return glm::length(outside);
    const glm::dvec3 inside = glm::min(point - box.low, box.high - point);
    return -std::min({inside.x, inside.y, inside.z});
}

/// Clearance of a long ball-end cutter (no holder within reach) from a box, by formula: the ball below its centre, and
/// the shank, nearest where it passes the box's height.
double ballClearance(const Box& box, const glm::dvec3& tip, double radius) {
    const glm::dvec3 centre = tip + glm::dvec3(0, 0, radius);
    const glm::dvec3 onShaft(tip.x, tip.y, std::max(centre.z, std::min(box.high.z, std::max(centre.z, box.low.z))));
    return std::min(boxDistance(box, centre), boxDistance(box, onShaft)) - radius;
}

/// Clearance of a flat-end cutter above or next to a box.
double flatClearance(const Box& box, const glm::dvec3& tip, double radius) {
    const glm::dvec2 outside = glm::max(
        glm::max(glm::dvec2(box.low) - glm::dvec2(tip), glm::dvec2(tip) - glm::dvec2(box.high)), glm::dvec2(0.0));
    const double across = glm::length(outside) - radius, above = tip.z - box.high.z;
    if (across > 0.0 && above > 0.0) return std::hypot(across, above);
    return std::max(across, above);
}

void shake(std::vector<Tick>& ticks, double amplitude, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> noise(-amplitude, amplitude);
    for (Tick& tick : ticks) tick.tip += glm::dvec3(noise(random), noise(random), noise(random));
}

const std::vector<Edit> heldEdits{{HoldOut{}}, {Simplify{}}};

} // namespace

class TestHoldOut : public QObject {
    Q_OBJECT

private slots:
    void aBallFollowsABoxWithoutEnteringIt_data() {
        QTest::addColumn<double>("allowance");
        QTest::newRow("finishing") << 0.0;
        QTest::newRow("roughing") << 0.5;
    }
    void aBallFollowsABoxWithoutEnteringIt() {
        QFETCH(double, allowance);
        const Box box{{-10, -8, 0}, {10, 8, 12}};
        const MeshDistance part(boxMesh(box));
        // Over the top in rows that extend beyond its edges, deeper than the corners allow, with a hand tremor.
        std::vector<glm::dvec3> corners;
        for (int row = 0; row < 6; ++row) {
            const double y = -9.0 + 3.6 * row, side = row % 2 == 0 ? 1.0 : -1.0;
            corners.push_back({-14.0 * side, y, 9.0});
            corners.push_back({-12.0 * side, y, 12.0 + allowance});
            corners.push_back({12.0 * side, y, 12.0 + allowance});
            corners.push_back({14.0 * side, y, 9.0});
        }
        std::vector<Tick> ticks = along(corners, 40.0);
        shake(ticks, 0.02, 5);
        const auto path =
            run({takeOf(ticks, allowance)}, heldEdits, contextOf(part, ballTool(), {{-30, -30, -5}, {30, 30, 15}}));
        QVERIFY2(path, path ? "" : path.error().place.c_str());
        double least = 1e9, nearOnTop = 0.0;
        walk(path->path.points, step, [&](const PathPoint&, const glm::dvec3& place) {
            const double clearance = ballClearance(box, place, 3.0);
            least = std::min(least, clearance);
            if (std::abs(place.x) < 9.0 && std::abs(place.y) < 7.0) nearOnTop = std::max(nearOnTop, clearance);
        });
        QVERIFY2(least >= allowance - 1e-4, qPrintable(QString::number(least)));
        // Where the hand was outside the part, the path is still the hand's.
        QVERIFY2(nearOnTop <= allowance + 0.02 + 0.005 + 0.007, qPrintable(QString::number(nearOnTop)));
    }

    void onlyPlacesThatEnterAreMoved() {
        const Box box{{-10, -10, 0}, {10, 10, 10}};
        const MeshDistance part(boxMesh(box));
        const std::vector<Tick> ticks = along({{-8, 0, 11}, {0, 0, 9.9}, {8, 0, 11}}, 20.0);
        const auto path =
            run({takeOf(ticks)}, {{HoldOut{}}}, contextOf(part, ballTool(), {{-30, -30, -5}, {30, 30, 15}}));
        QVERIFY(path);
        const std::vector<glm::dvec3> before{{-8, 0, 11}, {0, 0, 9.9}, {8, 0, 11}};
        for (const PathPoint& point : path->path.points) {
            if (point.pose.tip.z > 10.006) QVERIFY(distanceToPolyline(point.pose.tip, before) < 1e-6);
        }
        // Tip at 9.9, target 10.005: pushed by 0.105, and no value above what thinning may add.
        QVERIFY(path->reports.front().largestDeviation >= 0.105 - 1e-6);
        QVERIFY(path->reports.front().largestDeviation <= 0.105 + 0.002 + 1e-5);
        QVERIFY(std::abs(path->reports.front().worstPlace.x) < 0.1);
    }

    void aStraightMoveOverARidgeGoesAroundIt() {
        // Two ticks on either side, nothing between them: every sampled point between has to be kept out of the part
        // too.
        const Box ridge{{-0.5, -10, 0}, {0.5, 10, 10}};
        const MeshDistance part(boxMesh(ridge));
        for (const Tool& tool : {ballTool(), flatTool()}) {
            Take take = takeOf({{{-8, 0, 8}}, {{8, 1, 8}}});
            take.info.tickPeriod = 0.02;
            const auto path = run({take}, heldEdits, contextOf(part, tool, {{-30, -30, -5}, {30, 30, 15}}));
            QVERIFY2(path, path ? "" : path.error().place.c_str());
            double least = 1e9;
            walk(path->path.points, step, [&](const PathPoint&, const glm::dvec3& place) {
                least = std::min(least, tool.cutter.type == CutterType::ball ? ballClearance(ridge, place, 3.0)
                                                                             : flatClearance(ridge, place, 3.0));
            });
            QVERIFY2(least >= -1e-4, qPrintable(QString::number(least)));
            QVERIFY(path->path.points.front().pose.tip == glm::dvec3(-8, 0, 8));
            QVERIFY(path->path.points.back().pose.tip == glm::dvec3(8, 1, 8));
        }
    }

    void aGrooveThatIsTooNarrowIsLeftUpwards() {
        const Box left{{-10, -10, 0}, {-2.9, 10, 10}}, right{{2.9, -10, 0}, {10, 10, 10}};
        TriangleMesh mesh = boxMesh(left);
        append(mesh, boxMesh(right));
        const MeshDistance part(mesh);
        const auto path = run({takeOf(along({{0, -14, 4}, {0, 14, 4}}, 40.0))}, heldEdits,
                              contextOf(part, ballTool(), {{-30, -30, -5}, {30, 30, 15}}));
        QVERIFY2(path, path ? "" : path.error().place.c_str());
        walk(path->path.points, step, [&](const PathPoint&, const glm::dvec3& place) {
            QVERIFY(std::min(ballClearance(left, place, 3.0), ballClearance(right, place, 3.0)) >= -1e-4);
        });
    }

    void aSphereIsFollowedOnItsSurface() {
        const double radius = 20.0;
        const TriangleMesh mesh = sphereMesh({0, 0, 0}, radius, 150);
        const MeshDistance part(mesh);
        const double chord =
            radius * (1.0 - std::cos(std::acos(-1.0) / 300.0)); // facets are inside by at most twice this
        std::vector<Tick> ticks;
        for (int row = 0; row < 5; ++row) {
            for (int i = 0; i <= 2000; ++i) {
                const double x = (row % 2 == 0 ? 1.0 : -1.0) * (-12.0 + 0.012 * i), y = -4.0 + 2.0 * row;
                const double high = std::sqrt((radius + 3.0) * (radius + 3.0) - x * x - y * y);
                ticks.push_back({{x, y, high - 3.0}, false, sampleOnBoundary});
            }
        }
        shake(ticks, 0.03, 9);
        const auto path = run({takeOf(ticks)}, {{Smooth{5.0, 0.06}}, {HoldOut{}}, {Simplify{}}},
                              contextOf(part, ballTool(), {{-25, -25, -25}, {25, 25, 22}}));
        QVERIFY2(path, path ? "" : path.error().place.c_str());
        double least = 1e9, most = -1e9;
        walk(path->path.points, step, [&](const PathPoint& end, const glm::dvec3& place) {
            if (end.kind == MoveKind::rapid) return; // from row to row: not part of a stroke
            const double clearance = glm::length(place + glm::dvec3(0, 0, 3.0)) - 3.0 - radius;
            least = std::min(least, clearance);
            most = std::max(most, clearance);
        });
        QVERIFY2(least >= -2.0 * chord - 1e-4, qPrintable(QString::number(least)));
        QVERIFY2(most <= 0.03 * std::sqrt(3.0) + path->errorBudget, qPrintable(QString::number(most)));
        QVERIFY(path->path.points.size() * 4 < ticks.size());
    }

    void noRandomPathEntersTheBox() {
        const Box box{{-6, -6, 0}, {6, 6, 8}};
        const MeshDistance part(boxMesh(box));
        QVERIFY(rc::check("no place of any move is nearer than the allowance", [&] {
            const double allowance = *rc::gen::element(0.0, 0.3);
            const int count = *rc::gen::inRange(2, 12);
            std::vector<glm::dvec3> corners;
            for (int i = 0; i < count; ++i)
                corners.push_back({0.1 * *rc::gen::inRange(-120, 120), 0.1 * *rc::gen::inRange(-120, 120),
                                   0.1 * *rc::gen::inRange(-20, 140)});
            const auto path = run({takeOf(along(corners, 200.0), allowance)}, heldEdits,
                                  contextOf(part, ballTool(), {{-30, -30, -5}, {30, 30, 15}}));
            RC_ASSERT(static_cast<bool>(path));
            double least = 1e9;
            walk(path->path.points, 0.05, [&](const PathPoint&, const glm::dvec3& place) {
                least = std::min(least, ballClearance(box, place, 3.0));
            });
            RC_ASSERT(least >= allowance - 1e-4);
        }));
    }

    void twoEvaluationsGiveTheSamePath() {
        const Box box{{-10, -10, 0}, {10, 10, 10}};
        const MeshDistance part(boxMesh(box));
        std::vector<Tick> ticks = along({{-14, 0, 8}, {14, 1, 9.9}, {-14, 2, 9.9}, {14, 3, 9.9}}, 30.0);
        shake(ticks, 0.05, 11);
        const PathContext context = contextOf(part, ballTool(), {{-30, -30, -5}, {30, 30, 15}});
        const auto first = run({takeOf(ticks)}, standardEdits(), context);
        const auto second = run({takeOf(ticks)}, standardEdits(), context);
        QVERIFY(first && second);
        QVERIFY(tipsOf(first->path.points) == tipsOf(second->path.points));
    }
};

BURIN_TEST(TestHoldOut, NoApplication)

} // namespace burin::tst_hold_out

#include "tst_hold_out.moc"
