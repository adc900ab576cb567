// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// A point inserted into a path, against the formulas of its blend.
#include "core/path/edit_step.h"
#include "core/path/hand_interval.h"
#include "core/path/part_guard.h"
#include "core/path/stroke.h"
#include "path_fixture.h"
#include "tests/test_program.h"

#include <QTest>

#include <numbers>

namespace burin::tst_insert_point {

using namespace burin::test;

namespace {

constexpr std::int64_t planned = -2; // source of the generated moves
const MeshDistance nothing{TriangleMesh{}};

PathContext freeContext() {
    return contextOf(nothing, ballTool(), {{-100, -100, -50}, {100, 100, 0}});
}

/// One take, 0.02 mm per tick: from X 0 at tick 0 to X 10 at tick 500.
Take straightTake() {
    std::vector<Tick> ticks;
    for (int i = 0; i <= 500; ++i) ticks.push_back({{0.02 * i, 0.0, -1.0}});
    return takeOf(ticks);
}

/// A straight move of a planner from X 0 to X 30, then one along Y to 20, with moments 100, 110 and 120.
GeneratedMoves longMoves() {
    GeneratedMoves moves;
    moves.info = {planned, firstSetup, "pocket", "ball", 0.0, 0};
    moves.strokes = {{{{{0, 0, -1}}, 100}, {{{30, 0, -1}}, 110}, {{{30, 20, -1}}, 120}}};
    return moves;
}

Result<EvaluatedPath> plannedPath(const std::vector<Edit>& edits) {
    std::vector<SourceStrokes> sources;
    sources.push_back(*strokesOf(longMoves()));
    Progress progress;
    return evaluate("path", std::move(sources), edits, freeContext(), progress);
}

InsertPoint inserted(const Moment& at, const glm::dvec3& by, double length, double beyond = 0.0,
                     InsertPoint::Form form = InsertPoint::Form::smooth) {
    InsertPoint edit;
    edit.at = at;
    edit.by = by;
    edit.length = length;
    edit.beyond = beyond;
    edit.form = form;
    return edit;
}

double cosine(double off, double length) {
    return off < length ? 0.5 + 0.5 * std::cos(std::numbers::pi * off / length) : 0.0;
}

/// Y of the path's first straight part at X, mm.
double heightAt(const Path& path, double x) {
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        const glm::dvec3 &from = path.points[i - 1].pose.tip, &to = path.points[i].pose.tip;
        if (from.x <= x && x <= to.x && to.x > from.x) return std::lerp(from.y, to.y, (x - from.x) / (to.x - from.x));
    }
    return std::nan("");
}

bool areAt(const std::vector<glm::dvec3>& places, const std::vector<glm::dvec3>& expected) {
    return std::ranges::equal(places, expected, [](const glm::dvec3& place, const glm::dvec3& other) {
        return glm::distance(place, other) < 1e-9;
    });
}

bool hasPointAt(const Path& path, const glm::dvec3& place) {
    return std::ranges::any_of(path.points,
                               [&](const PathPoint& point) { return glm::distance(point.pose.tip, place) < 1e-9; });
}

} // namespace

class TestInsertPoint : public QObject {
    Q_OBJECT
private slots:
    /// In a take, whose points are dense, each point is displaced by the formula.
    void aTakeFollowsThePointSmoothly() {
        const glm::dvec3 by(0.0, 1.0, 0.5);
        const auto path = run({straightTake()}, {{inserted({1, 250}, by, 2.0)}}, freeContext());
        QVERIFY(path);
        QVERIFY(path->path.points.size() >= 501);
        for (const PathPoint& point : path->path.points) {
            const double share = cosine(std::abs(point.pose.tip.x - 5.0), 2.0);
            QVERIFY(glm::distance(point.pose.tip, {point.pose.tip.x, share, -1.0 + 0.5 * share}) < 1e-9);
        }
        QCOMPARE(path->reports.front().inserted.size(), std::size_t{1});
        QVERIFY(glm::distance(path->reports.front().inserted.front(), {5.0, 1.0, -0.5}) < 1e-9);
    }

    /// A planner's moves are divided, so that the curve lies within 0.001 mm of the formula, and nothing beyond it
    /// moves.
    void aLongMoveIsDivided() {
        for (const double size : {0.05, 0.8, 4.0})
            for (const double length : {1.0, 5.0, 10.0}) {
                const auto path = plannedPath({{inserted({planned, 100}, {0, size, 0}, length, 12.0)}});
                QVERIFY(path && hasPointAt(path->path, {12, size, -1}));
                for (double x = 0.0; x <= 30.0; x += 0.01) {
                    const double off = heightAt(path->path, x) - size * cosine(std::abs(x - 12.0), length);
                    QVERIFY2(std::abs(off) < 0.00101, qPrintable(QStringLiteral("%1 at %2").arg(off).arg(x)));
                }
                for (const glm::dvec3& corner : {glm::dvec3(0, 0, -1), {30, 0, -1}, {30, 20, -1}})
                    QVERIFY(hasPointAt(path->path, corner));
                QVERIFY(path->path.points.size() < 600);
            }
    }

    void aCornerIsStraight() {
        const auto path = plannedPath({{inserted({planned, 100}, {0, 2, 0}, 5.0, 12.0, InsertPoint::Form::corner)}});
        QVERIFY(path);
        QCOMPARE(path->path.points.size(), std::size_t{6});
        for (double x = 0.0; x <= 30.0; x += 0.01)
            QVERIFY(std::abs(heightAt(path->path, x) - 2.0 * std::max(0.0, 1.0 - std::abs(x - 12.0) / 5.0)) < 1e-9);
        // Without a length: from the ends of the move straight to the point.
        const auto alone = plannedPath({{inserted({planned, 100}, {0, 2, 0}, 0.0, 12.0)}});
        QVERIFY(alone);
        QCOMPARE(alone->path.points.size(), std::size_t{4});
        QVERIFY(hasPointAt(alone->path, {12, 2, -1}) && hasPointAt(alone->path, {0, 0, -1}));
    }

    /// On the line there is one more point and nothing else; the blend goes round corners along the stroke.
    void onTheLineNothingMoves() {
        const auto path = plannedPath({{inserted({planned, 110}, {}, 5.0, 8.0)}});
        QVERIFY(path);
        QCOMPARE(path->path.points.size(), std::size_t{4});
        QVERIFY(hasPointAt(path->path, {30, 8, -1}));
        QCOMPARE(run({straightTake()}, {{inserted({1, 250}, {}, 5.0)}}, freeContext())->path.points.size(),
                 std::size_t{501});
        const auto round = plannedPath({{inserted({planned, 110}, {0, 0, 1}, 5.0)}}); // at the corner itself
        QVERIFY(round && hasPointAt(round->path, {30, 0, 0}) && hasPointAt(round->path, {25, 0, -1}) &&
                hasPointAt(round->path, {30, 5, -1}));
    }

    /// Between moments by time, beyond the end of the stroke at its end, in a reversed stroke and its copies alike.
    void itIsWhereTheMomentIs() {
        const auto places = [](const std::vector<Edit>& edits) {
            const auto path = plannedPath(edits);
            return path ? path->reports.back().inserted : std::vector<glm::dvec3>{};
        };
        QVERIFY(areAt(places({{inserted({planned, 103}, {}, 5.0)}}), {{9, 0, -1}}));
        QVERIFY(areAt(places({{inserted({planned, 110}, {}, 5.0, 1000.0)}}), {{30, 20, -1}}));
        QVERIFY(areAt(places({{Reverse{}}, {inserted({planned, 110}, {}, 5.0, 4.0)}}), {{26, 0, -1}}));
        burin::Array copies;
        copies.step = {0, 50, 0};
        const std::vector<glm::dvec3> twice = places({{copies}, {inserted({planned, 103}, {0, 1, 0}, 2.0)}});
        QVERIFY(areAt(twice, {{9, 1, -1}, {9, 51, -1}}));
    }

    void aMomentThatIsMissingIsAnError() {
        const auto path =
            run({straightTake()}, {{CutOut{{1, 200, 300}}}, {inserted({1, 250}, {0, 1, 0}, 2.0)}}, freeContext());
        QVERIFY(!path);
        QCOMPARE(path.error().code, ErrorCode::argumentInvalid);
        QCOMPARE(path.error().subject, std::string("at"));
        QCOMPARE(path.error().place, std::string("take 1, tick 250"));
        QVERIFY(run({straightTake()}, {{InsertPoint{}}}, freeContext())); // no moment yet: nothing is inserted
    }

    /// Over a plate, a point inserted 3 mm deep in it is kept out; without an edit that does so the path is refused.
    void itDoesNotGouge() {
        const MeshDistance plate(boxMesh({{-20, -20, -10}, {40, 20, -1}})); // the tip is 0.2 mm above it
        const PathContext context = contextOf(plate, ballTool(), {{-20, -20, -10}, {40, 20, 5}});
        Take take = straightTake();
        for (Sample& sample : take.samples) sample.proxy.tip.z = -0.8;
        const InsertPoint edit = inserted({1, 250}, {0, 0.5, -3.0}, 2.0);
        const auto free = run({take}, {{edit}}, context), held = run({take}, {{edit}, {HoldOut{}}}, context);
        QVERIFY(free && held);
        const PartGuard guard(plate, ballTool());
        const auto least = [&](const Path& path) {
            double clearance = 1e9;
            for (std::size_t i = 1; i < path.points.size(); ++i)
                for (const glm::dvec3& place : placesOf(path.points[i - 1].pose.tip, path.points[i], 0.02))
                    clearance = std::min(clearance, guard.clearance(place, 10.0).clearance);
            return clearance;
        };
        QVERIFY(least(free->path) < -2.0);
        QVERIFY(least(held->path) >= -1e-6);
        const std::vector<Edit> unguarded{{edit}, {FitArcs{}}};
        QCOMPARE(checkOrder(unguarded).error().code, ErrorCode::editUnguarded);
    }

    /// The edit for a position on the evaluated path inserts the point there: in a take by its moment, in a planner's
    /// moves by the distance from the point before, also next to a point that was inserted before.
    void aPositionOnThePathBecomesTheEdit() {
        const std::vector<Edit> simplified{{Simplify{0.01}}};
        const auto simple = run({straightTake()}, simplified, freeContext());
        QVERIFY(simple);
        QCOMPARE(simple->path.points.size(), std::size_t{2});
        const InsertPoint inTake = insertionAt(simple->path.points, 0, 0.43);
        QVERIFY(inTake.at == (Moment{1, 215}) && inTake.beyond == 0.0);
        QVERIFY(glm::distance(run({straightTake()}, {{inTake}, {Simplify{}}}, freeContext())->reports[0].inserted[0],
                              {4.3, 0, -1}) < 1e-9);

        std::vector<Edit> edits{{inserted({planned, 100}, {}, 5.0, 10.0)}};
        const auto before = plannedPath(edits);
        QVERIFY(before);
        for (const auto& [piece, share, place] : std::vector<std::tuple<std::size_t, double, glm::dvec3>>{
                 {0, 0.5, {5, 0, -1}}, {1, 0.25, {15, 0, -1}}, {2, 0.75, {30, 15, -1}}}) {
            const auto after = plannedPath({edits.front(), {insertionAt(before->path.points, piece, share)}});
            QVERIFY(after && glm::distance(after->reports.back().inserted.front(), place) < 1e-9);
        }
    }

    /// A point of the path by its moment, and the moment of the nearest position.
    void positionsAndMomentsMatch() {
        const auto path = run({straightTake()}, {{Simplify{0.01}}}, freeContext());
        QVERIFY(path && pointAt(path->path, {1, 123}));
        QVERIFY(glm::distance(pointAt(path->path, {1, 123})->pose.tip, {2.46, 0, -1}) < 1e-9);
        QVERIFY(!pointAt(path->path, {2, 123}) && !pointAt(path->path, {1, 700}));
        QVERIFY(momentNear(path->path, {2.46, 3.0, 4.0}) == (Moment{1, 123}));
        QVERIFY(momentNear(path->path, {99.0, 3.0, 4.0}) == (Moment{1, 500}));
        QVERIFY(momentNear({}, {}) == Moment{});
        QVERIFY(glm::distance(*placeAt(path->path, {1, 123}, {}), {2.46, 0, -1}) < 1e-9);
        QVERIFY(glm::distance(*placeAt(path->path, {1, 123}, {{7.0, 0.3, 2}}), {7, 0, -1}) <
                1e-9); // where the tool was
        QVERIFY(!placeAt(path->path, {1, 700}, {{7.0, 0, 0}}));
    }
};

BURIN_TEST(TestInsertPoint, NoApplication)

} // namespace burin::tst_insert_point

#include "tst_insert_point.moc"
