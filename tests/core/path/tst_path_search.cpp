// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/arc.h"
#include "core/path/inserted_points.h"
#include "core/path/path_search.h"
#include "tests/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

namespace burin::tst_path_search {

namespace {

PathPoint point(const glm::dvec3& tip, MoveKind kind, std::int64_t tick) {
    return {{tip}, kind, 0.0, tick < 0 ? 0 : 7, tick, {}};
}

/// A walk in a box of 60 mm with rapids and points without a moment among its moves.
std::vector<PathPoint> walk(std::mt19937& random, std::size_t count) {
    std::uniform_real_distribution<double> step(-1.5, 1.5), share(0.0, 1.0);
    std::vector<PathPoint> points;
    glm::dvec3 tip(0.0);
    for (std::size_t i = 0; i < count; ++i) {
        tip = glm::clamp(tip + glm::dvec3(step(random), step(random), step(random)), -30.0, 30.0);
        const double kind = share(random);
        points.push_back(
            point(tip, kind < 0.1 ? MoveKind::rapid : MoveKind::cut, kind > 0.95 ? -1 : static_cast<std::int64_t>(i)));
    }
    return points;
}

/// The distance to the nearest position that can be taken, from points close to each other on every move.
double nearestOfMany(const std::vector<PathPoint>& points, const glm::dvec3& place) {
    constexpr int steps = 400;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (canBeTaken(points[i])) least = std::min(least, glm::distance(place, points[i].pose.tip));
        if (i == 0 || !canBeTaken(points[i - 1]) || !canBeTaken(points[i])) continue;
        for (int k = 1; k < steps; ++k)
            least = std::min(least, glm::distance(place, glm::mix(points[i - 1].pose.tip, points[i].pose.tip,
                                                                  static_cast<double>(k) / steps)));
    }
    return least;
}

} // namespace

class TestPathSearch : public QObject {
    Q_OBJECT
private slots:
    void theNearestPositionIsFound();
    void anArcIsFoundWhereItBulges();
    void nothingBeyondReachIsFound();
    void insertedPointsBelongToTheirEdits();
};

void TestPathSearch::theNearestPositionIsFound() {
    std::mt19937 random(37);
    std::uniform_real_distribution<double> place(-32.0, 32.0);
    const std::vector<PathPoint> points = walk(random, 900);
    const PathSearch search(points);
    for (int i = 0; i < 60; ++i) {
        const glm::dvec3 asked(place(random), place(random), place(random));
        const double expected = nearestOfMany(points, asked);
        const auto found = search.nearest(asked, 200.0);
        QVERIFY(found);
        QVERIFY2(found->distance <= expected + 1e-9 && found->distance > expected - 0.004,
                 qPrintable(QStringLiteral("%1 mm, expected %2 mm").arg(found->distance).arg(expected)));
        const PathPoint &from = points[found->piece], &to = points[found->piece + 1];
        QVERIFY(glm::distance(found->place, glm::mix(from.pose.tip, to.pose.tip, found->share)) < 1e-9);
        QVERIFY(std::abs(glm::distance(asked, found->place) - found->distance) < 1e-12);
        QVERIFY(canBeTaken(found->share < 0.5 ? from : to));
    }
}

/// A half circle of 10 mm: its middle is 10 mm away from the chord.
void TestPathSearch::anArcIsFoundWhereItBulges() {
    std::vector<PathPoint> points{point({-10.0, 0.0, 0.0}, MoveKind::cut, 0),
                                  point({10.0, 0.0, 0.0}, MoveKind::cut, 9)};
    points[1].arc = PathArc{glm::dvec3(0.0), 2, true};
    const auto found = PathSearch(points).nearest({0.0, 12.0, 0.0}, 3.0);
    QVERIFY(found);
    QVERIFY(std::abs(found->distance - 2.0) < 0.021); // the chord error of the search
    QVERIFY(std::abs(found->share - 0.5) < 0.02);
}

void TestPathSearch::nothingBeyondReachIsFound() {
    const std::vector<PathPoint> points{point({0.0, 0.0, 0.0}, MoveKind::cut, 0),
                                        point({9.0, 0.0, 0.0}, MoveKind::cut, 9),
                                        point({9.0, 9.0, 0.0}, MoveKind::rapid, -1)};
    const PathSearch search(points);
    QVERIFY(!search.nearest({4.0, 3.01, 0.0}, 3.0));
    QVERIFY(search.nearest({4.0, 2.99, 0.0}, 3.0));
    const auto end = search.nearest({9.5, 2.0, 0.0}, 3.0); // beside the rapid: the end of the cut
    QVERIFY(end);
    QCOMPARE(end->place, glm::dvec3(9.0, 0.0, 0.0));
    QVERIFY(!PathSearch({}).nearest(glm::dvec3(0.0), 1e6));
    QVERIFY(!PathSearch({points[0]}).nearest(glm::dvec3(0.0), 1e6)); // no move
}

void TestPathSearch::insertedPointsBelongToTheirEdits() {
    EvaluatedPath path;
    path.reports.resize(2);
    path.reports[1].inserted = {{1.0, 2.0, 3.0}};
    std::vector<Edit> edits{{Simplify{}}, {Simplify{}}, {InsertPoint{}}};
    edits[1].enabled = false; // has no report
    const std::vector<InsertedPoint> inserted = insertedPoints(path, edits);
    QCOMPARE(inserted.size(), std::size_t{1});
    QCOMPARE(inserted[0].edit, std::size_t{2});
    QCOMPARE(inserted[0].place, glm::dvec3(1.0, 2.0, 3.0));
}

BURIN_TEST(TestPathSearch, NoApplication)

} // namespace burin::tst_path_search

#include "tst_path_search.moc"
