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

/// A path with a rapid to the first corner and cuts to the others.
Path lineThrough(const std::vector<glm::dvec3>& corners) {
    Path path;
    for (const glm::dvec3& corner : corners)
        path.points.push_back(pointAt(corner, path.points.empty() ? MoveKind::rapid : MoveKind::cut));
    return path;
}

/// A full circle.
Path circleOf(double radius) {
    Path path = lineThrough({{radius, 0.0, 0.0}, {radius, 0.0, 0.0}});
    path.points.back().arc = PathArc{glm::dvec3(0.0), 2, false};
    return path;
}

PathDifference compared(const Path& first, const Path& second, double tolerance) {
    Progress progress;
    Result<PathDifference> comparison = differenceOf(first, second, tolerance, progress);
    return comparison ? std::move(*comparison) : PathDifference{};
}

bool near(double value, double expected, double within) {
    return std::abs(value - expected) <= within;
}

/// Returns the largest distance of a polyline from another one, by brute force over all segments, every 0.01 mm.
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
    /// Expected values computed by hand.
    void whatAPathComesTo() {
        Path path;
        path.points = {pointAt({0, 0, 10}, MoveKind::rapid),         pointAt({0, 30, 10}, MoveKind::rapid),
                       pointAt({0, 30, 0}, MoveKind::plunge, 100.0), pointAt({40, 30, 0}, MoveKind::cut, 800.0),
                       pointAt({40, 10, 0}, MoveKind::cut, 400.0),   pointAt({40, 10, 5}, MoveKind::retract, 1000.0)};
        path.points[4].arc = PathArc{{40.0, 20.0, 0.0}, 2, true}; // half a circle with a radius of 10 mm
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
        const PathDifference comparison = compared(circleOf(7.0), circleOf(7.0), 0.001);
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
        const PathDifference within = compared(first, second, 0.5001), beyond = compared(first, second, 0.4999);
        QVERIFY(near(within.ofFirst->largest, 0.5, 1e-12) && near(within.ofFirst->mean, 0.5, 1e-12));
        QVERIFY(within.ofFirst->farther == 0.0 && within.ofFirst->fartherParts.empty());
        QVERIFY(near(beyond.ofFirst->farther, 50.0, 1e-9) && near(beyond.ofFirst->fartherShare(), 1.0, 1e-9));
        QCOMPARE(beyond.ofFirst->fartherParts.size(), std::size_t{1});
        QCOMPARE(beyond.ofFirst->fartherParts[0].front(), glm::dvec3(0, 0, 0));
        QCOMPARE(beyond.ofFirst->fartherParts[0].back(), glm::dvec3(50, 0, 0));
        QVERIFY(beyond.ofFirst->fartherParts[0].size() <= 20); // not one point every 0.05 mm
    }

    /// Two lines from one point, 2° apart: the distance grows linearly.
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
        // In the other direction the path extends beyond the end: the distance is measured from that end.
        const PathDeviation back = *compared(first, second, tolerance).ofSecond;
        QVERIFY(near(back.largest, std::hypot(100.0 * run - 60.0, 100.0 * slope), 1e-9));
    }

    void circlesAreApartByTheirRadii() {
        const PathDifference comparison = compared(circleOf(10.0), circleOf(10.25), 0.1);
        QVERIFY(near(comparison.ofFirst->largest, 0.25, 2.0 * comparedChord));
        QVERIFY(near(comparison.ofSecond->mean, 0.25, 2.0 * comparedChord));
        QVERIFY(near(comparison.ofFirst->fartherShare(), 1.0, 1e-12));
    }

    /// A cut-off corner and a bump show in one direction only; each direction has its own result.
    void eachDirectionHasItsOwnAnswer() {
        const Path straight = lineThrough({{0, 0, 0}, {100, 0, 0}});
        const Path bump = lineThrough({{0, 0, 0}, {49, 0, 0}, {50, 8, 0}, {51, 0, 0}, {100, 0, 0}});
        const PathDifference comparison = compared(straight, bump, 0.01);
        QVERIFY(near(comparison.ofSecond->largest, 8.0, 1e-12));
        QCOMPARE(comparison.ofSecond->largestAt, glm::dvec3(50, 8, 0));
        QVERIFY(comparison.ofFirst->largest < 1.0);
        QCOMPARE(comparison.ofSecond->fartherParts.size(), std::size_t{1});
    }

    /// Compared with all segments of the other path, on zigzags that cross.
    void randomPathsAgreeWithBruteForce() {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> place(0.0, 20.0), height(0.0, 2.0);
        for (int trial = 0; trial < 6; ++trial) {
            std::vector<glm::dvec3> corners[2];
            for (int i = 0; i < 24; ++i)
                for (std::vector<glm::dvec3>& each : corners)
                    each.emplace_back(place(random), place(random), height(random));
            const PathDifference comparison = compared(lineThrough(corners[0]), lineThrough(corners[1]), 1.0);
            const double slow[] = {slowLargest(corners[0], corners[1]), slowLargest(corners[1], corners[0])};
            const double found[] = {comparison.ofFirst->largest, comparison.ofSecond->largest};
            for (int side = 0; side < 2; ++side) // each misses at most half of its spacing
                QVERIFY(found[side] <= slow[side] + 0.005 && found[side] >= slow[side] - 0.5 * comparedSpacing);
            const glm::dvec3 at = comparison.ofFirst->largestAt;
            QVERIFY(near(distanceToPolyline(at, corners[1]), found[0], 1e-9));
            QVERIFY(distanceToPolyline(at, corners[0]) < 1e-9);
            // The parts contain exactly what is farther than the tolerance.
            double length = 0.0;
            for (const std::vector<glm::dvec3>& part : comparison.ofFirst->fartherParts) {
                length += lengthAlong(part);
                for (std::size_t i = 1; i < part.size(); ++i)
                    QVERIFY(distanceToPolyline(0.5 * (part[i - 1] + part[i]), corners[1]) > 1.0 - comparedSpacing);
            }
            QVERIFY(near(length, comparison.ofFirst->farther, 1e-6));
        }
    }

    /// Plunges and links are not compared.
    void movesThatLeadToCutsDoNotCount() {
        Path linked = lineThrough({{0, 0, 0}, {10, 0, 0}});
        linked.points.insert(linked.points.begin(),
                             {pointAt({-50, 0, 80}, MoveKind::rapid), pointAt({0, 0, 30}, MoveKind::rapid),
                              pointAt({0, 0, 0}, MoveKind::plunge)});
        const PathDifference comparison = compared(linked, lineThrough({{0, 0, 0}, {10, 0, 0}}), 0.01);
        QCOMPARE(comparison.ofFirst->largest, 0.0);
        QCOMPARE(comparison.ofFirst->length, 10.0);
        const PathDifference nothing =
            compared(linked, Path{{}, {}, 0.0, Coolant::off, 0.0, {pointAt({0, 0, 0}, MoveKind::rapid)}}, 0.01);
        QVERIFY(!nothing.ofFirst && !nothing.ofSecond);
        QCOMPARE(nothing.second.points, std::size_t{1});
    }

    void whatCanNotBeComparedIsRefused() {
        const Path path = lineThrough({{0, 0, 0}, {10, 0, 0}});
        Progress progress;
        for (const double tolerance : {0.0, -1.0, std::nan(""), 1e6}) {
            const Result<PathDifference> refused = differenceOf(path, path, tolerance, progress);
            QVERIFY(!refused && refused.error().code == ErrorCode::argumentInvalid);
        }
        progress.cancel();
        const Result<PathDifference> cancelled = differenceOf(path, path, 0.01, progress);
        QVERIFY(!cancelled && cancelled.error().code == ErrorCode::cancelled);
    }
};

BURIN_TEST(TestPathComparison, NoApplication)

} // namespace burin::tst_path_comparison

#include "tst_path_comparison.moc"
