// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "block_fixture.h"

#include "core/path/stroke.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTest>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace burin::tst_sources {

using namespace burin::test;

namespace {

constexpr std::int64_t planned = -4; ///< the id of moves in these tests
constexpr double depth = -2.0;

/// Rows of a facing pass, 1 mm apart, with a point every 2 mm; the moment of a point is 1000 times its row plus its
/// column.
GeneratedMoves facing() {
    GeneratedMoves moves;
    moves.info = {planned, firstSetup, "facing", "flat", 0.0, 0};
    for (std::int64_t row = 0; row < 5; ++row) {
        std::vector<GeneratedPoint>& stroke = moves.strokes.emplace_back();
        for (std::int64_t column = 0; column <= 6; ++column) {
            const auto x = static_cast<double>(row % 2 == 0 ? 2 * column - 6 : 6 - 2 * column);
            stroke.push_back({{{x, static_cast<double>(row) - 2.0, depth}}, 1000 * row + column});
        }
    }
    return moves;
}

std::map<std::int64_t, glm::dvec3> placesOf(const GeneratedMoves& moves) {
    std::map<std::int64_t, glm::dvec3> places;
    for (const auto& stroke : moves.strokes)
        for (const GeneratedPoint& point : stroke) places[point.moment] = point.pose.tip;
    return places;
}

Take takeAbove() {
    Take take = takeOf(along({{-6, 4, depth}, {6, 4, depth}}, 50.0));
    take.info.toolId = "flat";
    return take;
}

/// The take, then the moves.
Result<EvaluatedPath> evaluated(const std::vector<Edit>& edits) {
    std::vector<SourceStrokes> sources;
    sources.push_back(*recordedStrokes(takeAbove()));
    sources.push_back(*strokesOf(facing()));
    Progress progress;
    return evaluate("path", std::move(sources), edits, blockContext(flatTool(4.0)), progress);
}

/// The cutting points of a source in a path, by their moments.
std::map<std::int64_t, glm::dvec3> cutOf(const Path& path, std::int64_t source) {
    std::map<std::int64_t, glm::dvec3> places;
    for (const PathPoint& point : path.points)
        if (point.source == source && point.kind == MoveKind::cut) places[point.sample] = point.pose.tip;
    return places;
}

} // namespace

class TestSources : public QObject {
    Q_OBJECT

private slots:
    /// Before any edit a path follows its sources exactly, in their order.
    void aPathOfBothGoesWhereBothGo() {
        const Result<EvaluatedPath> path = evaluated({});
        QVERIFY(path);
        std::map<std::int64_t, glm::dvec3> places;
        bool ofTheHand = true;
        for (const PathPoint& point : path->path.points) {
            if (point.source == planned) places[point.sample] = point.pose.tip;
            QVERIFY(ofTheHand || point.source == planned); // the take comes first
            ofTheHand = point.source != planned;
        }
        QVERIFY(places == placesOf(facing()));
    }

    /// Linked and with feeds like a recording: every point stays, at its own moment; the tool never deviates sideways.
    void theStandardEditsLeaveAPlannersPlaces() {
        const Result<EvaluatedPath> path = evaluated({{DropAirCuts{}}, {DropDwells{}}, {Link{}}, {SetFeed{}}});
        QVERIFY(path);
        const auto wanted = placesOf(facing()), made = cutOf(path->path, planned);
        for (const auto& [moment, place] : wanted) {
            const bool first = moment % 1000 == 0; // reached by a plunge
            QVERIFY2(first || (made.contains(moment) && made.at(moment) == place), qPrintable(QString::number(moment)));
        }
        QVERIFY(std::ranges::all_of(path->path.points, [](const PathPoint& point) {
            return point.kind == MoveKind::rapid || point.feed > 0.0;
        }));
    }

    /// Edits that use the hand's timing do not affect moves without timing.
    void filtersInTimeAreForTheHand() {
        const Result<EvaluatedPath> path = evaluated({{DropDwells{.speed = 100.0}}, {Smooth{}}, {SmoothSpline{}}});
        QVERIFY2(path, path ? "" : path.error().detail.c_str());
        std::map<std::int64_t, glm::dvec3> places;
        for (const PathPoint& point : path->path.points)
            if (point.source == planned) places[point.sample] = point.pose.tip;
        QVERIFY(places == placesOf(facing()));
    }

    /// A moment identifies a point of generated moves as a tick identifies one of a take, and nothing else.
    void editsNameAPlannersMoments() {
        Trim trim;
        trim.interval = {planned, 1002, 3004};
        const Edit edit{trim};
        const Result<Edit> again = editFromJson(toJson(edit));
        QVERIFY(again && toJson(*again) == toJson(edit));
        const Result<EvaluatedPath> path = evaluated({{CutOut{{planned, 1002, 3004}}}});
        QVERIFY(path);
        std::set<std::int64_t> left;
        for (const PathPoint& point : path->path.points)
            if (point.source == planned) left.insert(point.sample);
        for (const auto& [moment, place] : placesOf(facing()))
            QCOMPARE(left.contains(moment), moment < 1002 || moment > 3004);
        QVERIFY(std::ranges::any_of(path->path.points, [](const PathPoint& point) { return point.source == 1; }));
    }

    /// Edits are for upright tools: a tilted ball stands upright about the same centre; other tools are refused.
    void onlyABallMayBeTilted() {
        GeneratedMoves moves = facing();
        const glm::dvec3 axis(0.0, 0.6, 0.8);
        moves.strokes[2][3].pose.axis = axis;
        Progress progress;
        const auto flat = evaluate("path", {*strokesOf(moves)}, {}, blockContext(flatTool(4.0)), progress);
        QVERIFY(!flat);
        QCOMPARE(flat.error().code, ErrorCode::notSupported);
        QCOMPARE(flat.error().detail, std::string("pass 4"));
        moves.info.toolId = "ball";
        const auto ball = evaluate("path", {*strokesOf(moves)}, {}, blockContext(ballTool(4.0)), progress);
        QVERIFY(ball);
        const auto found = std::ranges::find(ball->path.points, 2003, &PathPoint::sample);
        QCOMPARE(found->pose.axis, glm::dvec3(0.0, 0.0, 1.0));
        const glm::dvec3 centre = moves.strokes[2][3].pose.tip + 2.0 * axis;
        QVERIFY(glm::distance(found->pose.tip + glm::dvec3(0.0, 0.0, 2.0), centre) < 1e-12);
    }

    void movesOfAnotherToolAreRefused() {
        Progress progress;
        const PathContext context = blockContext(ballTool(4.0));
        const Result<EvaluatedPath> path = evaluate("path", {*strokesOf(facing())}, {}, context, progress);
        QCOMPARE(path.error().code, ErrorCode::argumentInvalid);
        QVERIFY(path.error().detail.starts_with("pass 4"));
    }
};

BURIN_TEST(TestSources, QCoreApplication)

} // namespace burin::tst_sources

#include "tst_sources.moc"
