// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "path_fixture.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QTest>

#include <random>

namespace burin::tst_filters {

using namespace burin::test;

namespace {

/// Largest distance from a point of one polyline to the other, by dense sampling.
double oneSided(const std::vector<glm::dvec3>& from, const std::vector<glm::dvec3>& to, double step) {
    double largest = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const glm::dvec3 next = i + 1 < from.size() ? from[i + 1] : from[i];
        const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(glm::distance(from[i], next) / step)));
        for (std::size_t k = 0; k <= count; ++k)
            largest = std::max(
                largest,
                distanceToPolyline(glm::mix(from[i], next, static_cast<double>(k) / static_cast<double>(count)), to));
    }
    return largest;
}

std::vector<glm::dvec3> tipsOfTake(const Take& take) {
    std::vector<glm::dvec3> tips;
    for (const Sample& sample : take.samples) tips.push_back(sample.proxy.tip);
    return tips;
}

} // namespace

class TestFilters : public QObject {
    Q_OBJECT

private slots:
    void aSineOfTremorIsRemoved_data() {
        QTest::addColumn<double>("cutOff");
        QTest::addColumn<double>("frequency");
        QTest::addColumn<double>("left"); // share of the amplitude that is left: 1 / (1 + (f / fc)⁴)
        QTest::newRow("5 Hz takes 10 Hz away") << 5.0 << 10.0 << 1.0 / 17.0;
        QTest::newRow("4 Hz takes 12 Hz away") << 4.0 << 12.0 << 1.0 / 82.0;
        QTest::newRow("5 Hz keeps half of 5 Hz") << 5.0 << 5.0 << 0.5;
        QTest::newRow("5 Hz keeps a slow wave") << 5.0 << 0.5 << 1.0 / 1.0001;
    }
    void aSineOfTremorIsRemoved() {
        QFETCH(double, cutOff);
        QFETCH(double, frequency);
        QFETCH(double, left);
        std::vector<Tick> ticks;
        for (int i = 0; i < 10000; ++i)
            ticks.push_back({{0.02 * i, 0.1 * std::sin(2 * pi * frequency * 0.001 * i), -1.0}});
        const auto path = run({takeOf(ticks)}, {{Smooth{cutOff, 1.0}}}, contextOf(nothing_, ballTool(), stock_));
        QVERIFY(path);
        double amplitude = 0.0;
        for (std::size_t i = 3000; i < 7000; ++i) {
            amplitude = std::max(amplitude, std::abs(path->path.points[i].pose.tip.y));
            QVERIFY(std::abs(path->path.points[i].pose.tip.x - ticks[i].tip.x) < 1e-9); // no delay, lines stay lines
        }
        QVERIFY2(std::abs(amplitude / 0.1 - left) < 0.01 * left + 1e-4, qPrintable(QString::number(amplitude)));
    }

    /// A loop that is late has one tick for several periods. The frequency of the hand's tremor does not change.
    void tremorIsTheSameWhereTicksAreLate() {
        for (const bool spline : {false, true}) {
            Take take = takeOf(std::vector<Tick>(6000));
            std::mt19937 random(7);
            std::uniform_int_distribution<int> late(1, 4);
            std::int64_t period = 0;
            for (Sample& sample : take.samples) {
                sample.time = 0.001 * static_cast<double>(period);
                const double angle = 2 * pi * 10.0 * sample.time;
                sample.proxy.tip = {0.02 * static_cast<double>(period), 0.1 * std::sin(angle), -1.0};
                period += late(random);
            }
            const auto path = run({take}, {spline ? Edit{SmoothSpline{5.0, 1.0}} : Edit{Smooth{5.0, 1.0}}},
                                  contextOf(nothing_, ballTool(), stock_));
            QVERIFY(path);
            double amplitude = 0.0;
            const std::vector<PathPoint>& points = path->path.points;
            for (std::size_t i = points.size() / 4; i < points.size() / 4 * 3; ++i)
                amplitude = std::max(amplitude, std::abs(points[i].pose.tip.y));
            const double left = 1.0 / (1.0 + std::pow(2.0, spline ? 6 : 4)); // twice the cut-off
            // The path between late ticks is a chord: up to 0.8 % of the amplitude away from a sine.
            QVERIFY2(std::abs(amplitude / 0.1 - left) < 0.05 * left,
                     qPrintable(QString::number(amplitude / 0.1 / left)));
        }
    }

    void aCircleShrinksByTheStatedFigure_data() {
        QTest::addColumn<double>("radius");
        QTest::addColumn<double>("speed");
        QTest::addColumn<double>("loss"); // mm: references of the filter, cut-off 5 Hz
        QTest::newRow("r 5, 50 mm/s") << 5.0 << 50.0 << 0.051;
        QTest::newRow("r 5, 20 mm/s") << 5.0 << 20.0 << 0.0013;
        QTest::newRow("r 2, 20 mm/s") << 2.0 << 20.0 << 0.020;
    }
    void aCircleShrinksByTheStatedFigure() {
        QFETCH(double, radius);
        QFETCH(double, speed);
        QFETCH(double, loss);
        std::vector<Tick> ticks;
        for (int i = 0; i < 12000; ++i) {
            const double angle = 0.001 * i * speed / radius;
            ticks.push_back({{radius * std::cos(angle), radius * std::sin(angle), 0.0}});
        }
        const auto path = run({takeOf(ticks)}, {{Smooth{5.0, 1.0}}}, contextOf(nothing_, ballTool(), stock_));
        QVERIFY(path);
        const double frequency = speed / (2 * pi * radius);
        const double exact = radius * (1.0 - 1.0 / (1.0 + std::pow(frequency / 5.0, 4)));
        QVERIFY(std::abs(exact - loss) < 0.05 * loss);
        const glm::dvec3 tip = path->path.points[6000].pose.tip;
        QVERIFY(std::abs(radius - std::hypot(tip.x, tip.y) - exact) < 0.02 * exact);
    }

    void smoothingStaysWithinItsTolerance() {
        std::mt19937 random(3);
        std::normal_distribution<double> noise(0.0, 0.05);
        std::vector<Tick> ticks = along({{0, 0, 0}, {30, 0, 0}, {30, 20, -3}, {0, 20, 0}}, 25.0);
        for (Tick& tick : ticks) tick.tip += glm::dvec3(noise(random), noise(random), noise(random));
        const Take take = takeOf(ticks);
        const auto path = run({take}, {{Smooth{5.0, 0.02}}}, contextOf(nothing_, ballTool(), stock_));
        QVERIFY(path);
        double largest = 0.0;
        for (std::size_t i = 0; i < ticks.size(); ++i)
            largest = std::max(largest, glm::distance(ticks[i].tip, path->path.points[i].pose.tip));
        QVERIFY(largest <= 0.02 + 1e-12);
        QVERIFY(std::abs(path->reports.front().largestDeviation - largest) < 1e-12);
        QVERIFY(std::abs(path->errorBudget - largest) < 1e-12);
    }

    void stepsOfAnEncoderDoNotComeBackWhereTheToleranceIsUsedUp() {
        // A hand with more tremor than the tolerance allows to remove, read by an encoder of 0.02 mm.
        const auto seen = [](double value) { return 0.02 * std::round(value / 0.02); };
        std::vector<Tick> ticks;
        for (int i = 0; i < 6000; ++i) {
            const double tremor = 2 * pi * 10.0 * 0.001 * i;
            ticks.push_back({{seen(0.05 * i), seen(0.08 * std::sin(tremor)), seen(0.08 * std::cos(tremor))}});
        }
        const auto bend = [](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
            return glm::length(a - 2.0 * b + c);
        };
        const auto path = run({takeOf(ticks)}, {{Smooth{5.0, 0.03}}}, contextOf(nothing_, ballTool(), stock_));
        QVERIFY(path);
        double before = 0.0, after = 0.0;
        for (std::size_t i = 1001; i < 5000; ++i) {
            before = std::max(before, bend(ticks[i - 1].tip, ticks[i].tip, ticks[i + 1].tip));
            const auto& points = path->path.points;
            after = std::max(after, bend(points[i - 1].pose.tip, points[i].pose.tip, points[i + 1].pose.tip));
        }
        QVERIFY(before >= 0.02);
        QVERIFY2(after < 0.1 * before, qPrintable(QString::number(after))); // the tremor itself bends by 0.0003 mm
    }

    void aJumpOfTheTipIsAGap() {
        std::vector<Tick> ticks = along({{0, 0, 0}, {10, 0, 0}}, 20.0);
        append(ticks, along({{10, 10, 0}, {0, 10, 0}}, 20.0));
        const auto path = run({takeOf(ticks)}, {{Smooth{2.0, 5.0}}}, contextOf(nothing_, ballTool(), stock_));
        QVERIFY(path);
        for (const PathPoint& point : path->path.points)
            QVERIFY(std::abs(point.pose.tip.y) < 1e-9 || std::abs(point.pose.tip.y - 10.0) < 1e-9);
        QCOMPARE(std::ranges::count(path->path.points, MoveKind::rapid, &PathPoint::kind), 2);
    }

    void smoothingDoesNotReachAcrossAGap() {
        std::vector<Tick> ticks = along({{0, 0, 0}, {10, 0, 0}}, 20.0);
        append(ticks, along({{10, 0, 0}, {10, 10, 0}}, 20.0, true, sampleShankContact));
        append(ticks, along({{10, 10, 0}, {0, 10, 0}}, 20.0));
        const auto path = run({takeOf(ticks)}, {{Smooth{2.0, 5.0}}}, contextOf(nothing_, ballTool(), stock_));
        QVERIFY(path);
        for (const PathPoint& point : path->path.points)
            QVERIFY(std::abs(point.pose.tip.y) < 1e-9 || std::abs(point.pose.tip.y - 10.0) < 1e-9);
    }

    void simplifyKeepsWithinToleranceOfAnyPolyline() {
        QVERIFY(rc::check("Hausdorff distance both ways", [this] {
            const auto steps = *rc::gen::container<std::vector<std::array<int, 3>>>(
                rc::gen::container<std::array<int, 3>>(rc::gen::inRange(-10, 11)));
            RC_PRE(steps.size() >= 2);
            const double tolerance = *rc::gen::inRange(1, 100) / 100.0;
            std::vector<Tick> ticks{{glm::dvec3(0.0)}};
            for (const auto& step : steps)
                ticks.push_back({ticks.back().tip + 0.1 * glm::dvec3(step[0], step[1], step[2])});
            const Take take = takeOf(ticks);
            const auto path = run({take}, {{Simplify{tolerance}}}, contextOf(nothing_, ballTool(), stock_));
            RC_ASSERT(static_cast<bool>(path));
            const std::vector<glm::dvec3> before = tipsOfTake(take), after = tipsOf(path->path.points);
            RC_ASSERT(before.front() == after.front() && before.back() == after.back());
            const double there = oneSided(before, after, 0.02), back = oneSided(after, before, 0.02);
            RC_ASSERT(there <= tolerance + 1e-9);
            RC_ASSERT(back <= tolerance + 1e-9);
            RC_ASSERT(there <= path->reports.front().largestDeviation + 1e-9);
        }));
    }

    void simplifyNeedsFewPointsForStraightWays() {
        const auto path = run({takeOf(along({{0, 0, 0}, {30, 0, 0}, {30, 20, 0}, {0, 20, 0}}, 25.0))},
                              {{Simplify{0.005}}}, contextOf(nothing_, ballTool(), stock_));
        QVERIFY(path);
        // Groups of a few thousand points are simplified separately and leave a point each.
        QVERIFY(path->path.points.size() >= 4 && path->path.points.size() <= 6);
    }

    void airIsDroppedAndWorkStays() {
        std::vector<Tick> ticks = along({{-10, 0, 5}, {0, 0, 0}}, 25.0, false);         // moving there
        append(ticks, along({{0, 0, 0}, {10, 0, 0}}, 25.0));                            // cut
        append(ticks, along({{10, 0, 0}, {12, 0, 0}}, 25.0, false));                    // a short gap is kept
        append(ticks, along({{12, 0, 0}, {20, 0, 0}}, 25.0));                           // cut
        append(ticks, along({{20, 0, 0}, {20, 10, 3}, {20, 10, 0}}, 25.0, false));      // air
        append(ticks, along({{20, 10, 0}, {0, 10, 0}}, 25.0, false, sampleOnBoundary)); // a finishing pass
        append(ticks, along({{0, 10, 0}, {0, 10, 30}}, 25.0, false));                   // moving away
        const auto path = run({takeOf(ticks)}, {{DropAirCuts{3.0}}}, contextOf(nothing_, ballTool(), stock_));
        QVERIFY(path);
        std::vector<bool> kept(ticks.size());
        for (const PathPoint& point : path->path.points) kept[static_cast<std::size_t>(point.sample)] = true;
        for (std::size_t i = 0; i < ticks.size(); ++i) {
            const bool works = ticks[i].removes || (ticks[i].flags & sampleOnBoundary) != 0;
            const bool shortGap =
                !works && ticks[i].tip.y == 0.0 && ticks[i].tip.x >= 10.0 && ticks[i].tip.x <= 12.0 && i > 400;
            // The point where work begins is kept as well: the material removed there was removed on the move from it.
            const bool begins = i + 1 < ticks.size() && !works && (ticks[i + 1].removes || ticks[i + 1].flags != 0);
            QCOMPARE(bool(kept[i]), works || shortGap || begins);
        }
        std::size_t strokes = 0;
        for (const PathPoint& point : path->path.points) strokes += point.kind == MoveKind::rapid ? 1 : 0;
        QCOMPARE(strokes, std::size_t{2});
        QCOMPARE(path->reports.front().largestDeviation, 0.0);
    }

    void standingStillIsDropped() {
        std::vector<Tick> ticks = along({{0, 0, 0}, {10, 0, 0}}, 25.0);
        std::vector<Tick> still;
        for (int i = 0; i < 800; ++i) still.push_back({{10 + 0.02 * std::sin(0.06 * i), 0, 0}, false});
        append(ticks, still);
        append(ticks, along({{10, 0, 0}, {10, 10, 0}}, 25.0));
        std::vector<Tick> plunge; // slower than a dwell, but cutting
        for (int i = 0; i < 2000; ++i) plunge.push_back({{10, 10, -0.0005 * i}, true});
        append(ticks, plunge);
        const auto path = run({takeOf(ticks)}, {{DropDwells{1.0, 0.15}}}, contextOf(nothing_, ballTool(), stock_));
        QVERIFY(path);
        const std::size_t dropped = ticks.size() - path->path.points.size();
        QVERIFY2(dropped > 650 && dropped <= 800, qPrintable(QString::number(dropped)));
        QVERIFY(path->reports.front().largestDeviation <= 0.05);
        std::size_t plunging = 0;
        for (const PathPoint& point : path->path.points) plunging += point.pose.tip.z < 0.0 ? 1 : 0;
        QCOMPARE(plunging, std::size_t{1999});
    }

    void slowWorkOnTheBoundaryKeepsItsShape() {
        std::vector<Tick> ticks;
        for (int i = 0; i < 6000; ++i) { // creeps around a corner at 0.5 mm/s
            const double s = 0.0005 * i;
            ticks.push_back({{std::min(s, 1.5), std::max(0.0, s - 1.5), 0}, false, sampleOnBoundary});
        }
        const Take take = takeOf(ticks);
        const auto path = run({take}, {{DropDwells{1.0, 0.15}}}, contextOf(nothing_, ballTool(), stock_));
        QVERIFY(path);
        QVERIFY(oneSided(tipsOfTake(take), tipsOf(path->path.points), 0.01) <= 0.05);
    }

private:
    const MeshDistance nothing_{TriangleMesh{}};
    const Box stock_{{-50, -50, -20}, {50, 50, 0}};
};

BURIN_TEST(TestFilters, NoApplication)

} // namespace burin::tst_filters

#include "tst_filters.moc"
