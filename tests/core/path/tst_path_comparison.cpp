// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/path_comparison.h"
#include "path_fixture.h"
#include "tests/test_program.h"

#include <QtTest>

#include <cmath>
#include <random>

namespace burin::tst_path_comparison {

using namespace burin::test;

namespace {

PathPoint pointAt(const glm::dvec3& tip, MoveKind kind = MoveKind::cut, double feed = 600.0) {
    PathPoint point;
    point.pose.tip = tip;
    point.kind = kind;
    point.feed = kind == MoveKind::rapid ? 0.0 : feed;
    return point;
}

/// A rapid to the first corner, cuts to the others.
Path lineThrough(const std::vector<glm::dvec3>& corners) {
    Path path;
    for (const glm::dvec3& corner : corners)
        path.points.push_back(pointAt(corner, path.points.empty() ? MoveKind::rapid : MoveKind::cut));
    return path;
}

/// A full turn.
Path circleOf(double radius) {
    Path path = lineThrough({{radius, 0.0, 0.0}, {radius, 0.0, 0.0}});
    path.points.back().arc = PathArc{glm::dvec3(0.0), 2, false};
    return path;
}

PathComparison compared(const Path& first, const Path& second, double tolerance) {
    Progress progress;
    Result<PathComparison> comparison = comparePaths(first, second, tolerance, progress);
    return comparison ? std::move(*comparison) : PathComparison{};
}

bool near(double value, double expected, double within) {
    return std::abs(value - expected) <= within;
}

/// The farthest place of a polyline from another one, all segments looked at, every hundredth of a millimetre.
double slowLargest(const std::vector<glm::dvec3>& from, const std::vector<glm::dvec3>& to) {
    double largest = 0.0;
    for (std::size_t i = 1; i < from.size(); ++i)
        for (const glm::dvec3& place : placesOf(from[i - 1], pointAt(from[i]), 0.01))
            largest = std::max(largest, distanceToPolyline(place, to));
    return largest;
}

} // namespace

class TestPathComparison : public QObject {
    Q_OBJECT
private slots:
    /// Counted by hand.
    void whatAPathComesTo() {
        Path path;
        path.points = {pointAt({0, 0, 10}, MoveKind::rapid),         pointAt({0, 30, 10}, MoveKind::rapid),
                       pointAt({0, 30, 0}, MoveKind::plunge, 100.0), pointAt({40, 30, 0}, MoveKind::cut, 800.0),
                       pointAt({40, 10, 0}, MoveKind::cut, 400.0),   pointAt({40, 10, 5}, MoveKind::retract, 1000.0)};
        path.points[4].arc = PathArc{{40.0, 20.0, 0.0}, 2, true}; // half a turn of radius 10
        const PathTotals totals = totalsOf(path);
        const double halfTurn = 10.0 * std::acos(-1.0);
        QVERIFY(near(totals.cutting, 40.0 + halfTurn, 1e-9));
        QCOMPARE(totals.plunging, 10.0);
        QCOMPARE(totals.air, 35.0);
        QCOMPARE(totals.points, std::size_t{6});
        QCOMPARE(totals.arcs, std::size_t{1});
        QVERIFY(totals.feedTime && near(*totals.feedTime, 6.0 + 3.0 + 60.0 * halfTurn / 400.0 + 0.3, 1e-9));
        path.points[3].feed = 0.0; // as recorded: no feed yet
        QVERIFY(!totalsOf(path).feedTime);
        QCOMPARE(totalsOf({}).points, std::size_t{0});
    }

    void aPathIsTheSameAsItself() {
        const PathComparison comparison = compared(circleOf(7.0), circleOf(7.0), 0.001);
        QVERIFY(comparison.ofFirst && comparison.ofSecond);
        for (const PathDeviation* each : {&*comparison.ofFirst, &*comparison.ofSecond}) {
            QVERIFY(each->largest < 1e-12 && each->mean < 1e-12);
            QCOMPARE(each->farther, 0.0);
            QVERIFY(each->fartherParts.empty());
        }
    }

    void parallelLinesAreEquallyFarEverywhere() {
        const Path first = lineThrough({{0, 0, 0}, {50, 0, 0}});
        const Path second = lineThrough({{0, 0.3, 0.4}, {20, 0.3, 0.4}, {50, 0.3, 0.4}}); // 3-4-5
        const PathComparison within = compared(first, second, 0.5001), beyond = compared(first, second, 0.4999);
        QVERIFY(near(within.ofFirst->largest, 0.5, 1e-12) && near(within.ofFirst->mean, 0.5, 1e-12));
        QVERIFY(within.ofFirst->farther == 0.0 && within.ofFirst->fartherParts.empty());
        QVERIFY(near(beyond.ofFirst->farther, 50.0, 1e-9) && near(beyond.ofFirst->fartherShare(), 1.0, 1e-9));
        QCOMPARE(beyond.ofFirst->fartherParts.size(), std::size_t{1});
        QCOMPARE(beyond.ofFirst->fartherParts[0].front(), glm::dvec3(0, 0, 0));
        QCOMPARE(beyond.ofFirst->fartherParts[0].back(), glm::dvec3(50, 0, 0));
        QVERIFY(beyond.ofFirst->fartherParts[0].size() <= 20); // not one place every 0.05 mm
    }

    /// Two lines out of one point, 2° apart: the distance grows evenly.
    void aSpreadingLineIsFartherFromACertainPointOn() {
        const double slope = std::sin(2.0 * std::acos(-1.0) / 180.0), run = std::sqrt(1.0 - slope * slope);
        const Path first = lineThrough({{0, 0, 0}, {60, 0, 0}});
        const Path second = lineThrough({{0, 0, 0}, {100.0 * run, 100.0 * slope, 0}});
        const double tolerance = 0.4;
        const PathDeviation deviation = *compared(first, second, tolerance).ofFirst;
        QVERIFY(near(deviation.largest, 60.0 * slope, 1e-9));
        QCOMPARE(deviation.largestAt, glm::dvec3(60, 0, 0));
        QVERIFY(near(deviation.mean, 30.0 * slope, 1e-9));
        QVERIFY(near(deviation.farther, 60.0 - tolerance / slope, 1e-6));
        QCOMPARE(deviation.fartherParts.size(), std::size_t{1});
        QVERIFY(near(deviation.fartherParts[0].front().x, tolerance / slope, 1e-6));
        // The other way round it sticks out beyond the end: the distance from that end.
        const PathDeviation back = *compared(first, second, tolerance).ofSecond;
        QVERIFY(near(back.largest, std::hypot(100.0 * run - 60.0, 100.0 * slope), 1e-9));
    }

    void circlesAreApartByTheirRadii() {
        const PathComparison comparison = compared(circleOf(10.0), circleOf(10.25), 0.1);
        QVERIFY(near(comparison.ofFirst->largest, 0.25, 2.0 * comparedChord));
        QVERIFY(near(comparison.ofSecond->mean, 0.25, 2.0 * comparedChord));
        QVERIFY(near(comparison.ofFirst->fartherShare(), 1.0, 1e-12));
    }

    /// What a corner cut off and a bump do is seen from one of both sides alone; each direction has its own answer.
    void eachDirectionHasItsOwnAnswer() {
        const Path straight = lineThrough({{0, 0, 0}, {100, 0, 0}});
        const Path bump = lineThrough({{0, 0, 0}, {49, 0, 0}, {50, 8, 0}, {51, 0, 0}, {100, 0, 0}});
        const PathComparison comparison = compared(straight, bump, 0.01);
        QVERIFY(near(comparison.ofSecond->largest, 8.0, 1e-12));
        QCOMPARE(comparison.ofSecond->largestAt, glm::dvec3(50, 8, 0));
        QVERIFY(comparison.ofFirst->largest < 1.0);
        QCOMPARE(comparison.ofSecond->fartherParts.size(), std::size_t{1});
    }

    /// Against all segments of the other path, on zigzags that cross.
    void randomPathsAgreeWithBruteForce() {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> place(0.0, 20.0), height(0.0, 2.0);
        for (int trial = 0; trial < 6; ++trial) {
            std::vector<glm::dvec3> corners[2];
            for (int i = 0; i < 24; ++i)
                for (std::vector<glm::dvec3>& each : corners)
                    each.emplace_back(place(random), place(random), height(random));
            const PathComparison comparison = compared(lineThrough(corners[0]), lineThrough(corners[1]), 1.0);
            const double slow[] = {slowLargest(corners[0], corners[1]), slowLargest(corners[1], corners[0])};
            const double found[] = {comparison.ofFirst->largest, comparison.ofSecond->largest};
            for (int side = 0; side < 2; ++side) // either misses half of its spacing at most
                QVERIFY(found[side] <= slow[side] + 0.005 && found[side] >= slow[side] - 0.5 * comparedSpacing);
            const glm::dvec3 at = comparison.ofFirst->largestAt;
            QVERIFY(near(distanceToPolyline(at, corners[1]), found[0], 1e-9));
            QVERIFY(distanceToPolyline(at, corners[0]) < 1e-9);
            // All that is farther is in a part, and nothing else.
            double length = 0.0;
            for (const std::vector<glm::dvec3>& part : comparison.ofFirst->fartherParts) {
                length += lengthAlong(part);
                for (std::size_t i = 1; i < part.size(); ++i)
                    QVERIFY(distanceToPolyline(0.5 * (part[i - 1] + part[i]), corners[1]) > 1.0 - comparedSpacing);
            }
            QVERIFY(near(length, comparison.ofFirst->farther, 1e-6));
        }
    }

    /// Plunges and links are not what is compared.
    void movesThatLeadToCutsDoNotCount() {
        Path linked = lineThrough({{0, 0, 0}, {10, 0, 0}});
        linked.points.insert(linked.points.begin(),
                             {pointAt({-50, 0, 80}, MoveKind::rapid), pointAt({0, 0, 30}, MoveKind::rapid),
                              pointAt({0, 0, 0}, MoveKind::plunge)});
        const PathComparison comparison = compared(linked, lineThrough({{0, 0, 0}, {10, 0, 0}}), 0.01);
        QCOMPARE(comparison.ofFirst->largest, 0.0);
        QCOMPARE(comparison.ofFirst->length, 10.0);
        const PathComparison nothing =
            compared(linked, Path{{}, {}, 0.0, Coolant::off, 0.0, {pointAt({0, 0, 0}, MoveKind::rapid)}}, 0.01);
        QVERIFY(!nothing.ofFirst && !nothing.ofSecond);
        QCOMPARE(nothing.second.points, std::size_t{1});
    }

    void whatCanNotBeComparedIsRefused() {
        const Path path = lineThrough({{0, 0, 0}, {10, 0, 0}});
        Progress progress;
        for (const double tolerance : {0.0, -1.0, std::nan(""), 1e6}) {
            const Result<PathComparison> refused = comparePaths(path, path, tolerance, progress);
            QVERIFY(!refused && refused.error().code == ErrorCode::argumentInvalid);
        }
        progress.cancel();
        const Result<PathComparison> cancelled = comparePaths(path, path, 0.01, progress);
        QVERIFY(!cancelled && cancelled.error().code == ErrorCode::cancelled);
    }
};

BURIN_TEST(TestPathComparison, NoApplication)

} // namespace burin::tst_path_comparison

#include "tst_path_comparison.moc"
