// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// A path whose edits are changed one after the other is the same whether states of earlier evaluations are used or not.
#include "core/geometry/segment.h"
#include "core/path/hand_trail.h"
#include "core/path/kept_edits.h"
#include "path_fixture.h"
#include "tests/test_program.h"

#include <QTest>

#include <random>

namespace burin::tst_kept_edits {

using namespace burin::test;

namespace {

const TriangleMesh block = boxMesh({{-30, -30, -20}, {30, 30, -2}});

std::vector<Edit> someEdits() {
    std::vector<Edit> edits{{DropDwells{}}, {SmoothShape{}}, {MovePoints{}}, {HoldOut{}},
                            {Simplify{}},   {Link{}},        {SetFeed{}}};
    auto& move = std::get<MovePoints>(edits[2].parameters);
    move.interval = {1, 300, 300};
    move.by = {0.0, 1.0, 0.0};
    return edits;
}

std::vector<SourceStrokes> sources() {
    std::vector<SourceStrokes> strokes;
    strokes.push_back(*recordedStrokes(takeOf(along({{-20, 0, -1}, {20, 3, -1}, {20, 9, -1.5}, {-20, 6, -1}}, 60.0))));
    return strokes;
}

bool alike(const PathPoint& one, const PathPoint& other) {
    return one.pose.tip == other.pose.tip && one.kind == other.kind && one.feed == other.feed &&
           one.source == other.source && one.sample == other.sample && one.arc == other.arc &&
           one.spindleSpeed == other.spindleSpeed && one.coolant == other.coolant;
}

bool alike(const EditReport& one, const EditReport& other) {
    return one.edit == other.edit && one.pointsBefore == other.pointsBefore && one.pointsAfter == other.pointsAfter &&
           one.largestDeviation == other.largestDeviation && one.worstPlace == other.worstPlace &&
           one.omissions.size() == other.omissions.size() && one.inserted == other.inserted;
}

bool alike(const EvaluatedPath& one, const EvaluatedPath& other) {
    const auto points = [](const PathPoint& a, const PathPoint& b) { return alike(a, b); };
    const auto reports = [](const EditReport& a, const EditReport& b) { return alike(a, b); };
    return std::ranges::equal(one.path.points, other.path.points, points) &&
           std::ranges::equal(one.reports, other.reports, reports) && one.errorBudget == other.errorBudget &&
           one.path.spindleSpeed == other.path.spindleSpeed && one.path.coolant == other.path.coolant;
}

} // namespace

class TestKeptEdits : public QObject {
    Q_OBJECT
private slots:
    void theResultIsThatOfAllEdits();
    void onlyWhatChangedIsAppliedAnew();
    void anotherContextBeginsAnew();
    void anotherObstacleOfTheSameExtentBeginsAnew();
    void theFirstResultFollowsTheChangedEdit();
    void reportsAndTrailsCountAsMemory();
};

void TestKeptEdits::theResultIsThatOfAllEdits() {
    const MeshDistance part{block};
    const PathContext context = contextOf(part, ballTool(), {{-30, -30, -20}, {30, 30, 0}});
    std::mt19937 random(11);
    std::vector<Edit> edits = someEdits();
    KeptEdits kept;
    Progress progress;
    for (int i = 0; i < 25; ++i) {
        const auto place = static_cast<std::size_t>(random() % edits.size());
        if (random() % 3 == 0) edits[place].enabled = !edits[place].enabled || place == 3 || place == 5;
        auto& move = std::get<MovePoints>(edits[2].parameters);
        if (place == 1)
            std::get<SmoothShape>(edits[1].parameters).wavelength = 1.0 + static_cast<double>(random() % 40) / 10.0;
        if (place == 2) move.by.y = static_cast<double>(random() % 50) / 10.0;
        if (place == 4)
            std::get<Simplify>(edits[4].parameters).tolerance = 0.005 + static_cast<double>(random() % 5) / 100.0;
        if (place == 6)
            std::get<SetFeed>(edits[6].parameters).speedFactor = 0.5 + static_cast<double>(random() % 5) / 10.0;
        const auto quick = evaluate("path", sources(), edits, context, progress, {&kept, {}});
        const auto whole = evaluate("path", sources(), edits, context, progress);
        QVERIFY(quick && whole);
        QVERIFY2(alike(*quick, *whole), qPrintable(QStringLiteral("after change %1 of edit %2").arg(i).arg(place)));
    }
}

void TestKeptEdits::onlyWhatChangedIsAppliedAnew() {
    const MeshDistance part{block};
    const PathContext context = contextOf(part, ballTool(), {{-30, -30, -20}, {30, 30, 0}});
    std::vector<Edit> edits = someEdits();
    KeptEdits kept;
    Progress progress;
    QVERIFY(evaluate("path", sources(), edits, context, progress, {&kept, {}}));
    std::get<MovePoints>(edits[2].parameters).by.y = 2.0;
    kept.begin(edits, context);
    QCOMPARE(kept.count(), std::size_t{2}); // what DropDwells and SmoothShape left
    // Sources are not even looked at while a state is kept: none are given.
    QVERIFY(evaluate("path", std::vector<SourceStrokes>{}, edits, context, progress, {&kept, {}}));
    edits.erase(edits.begin()); // everything follows it
    kept.begin(edits, context);
    QCOMPARE(kept.count(), std::size_t{0});
    const std::vector<SourceStrokes> own = sources(); // that stay with the caller
    const auto quick = evaluate("path", std::vector<SourceStrokes>{}, edits, context, progress, {&kept, {}, &own});
    const auto whole = evaluate("path", sources(), edits, context, progress);
    QVERIFY(quick && whole);
    QVERIFY(alike(*quick, *whole));
}

void TestKeptEdits::anotherContextBeginsAnew() {
    const MeshDistance part{block};
    PathContext context = contextOf(part, ballTool(), {{-30, -30, -20}, {30, 30, 0}});
    const std::vector<Edit> edits = someEdits();
    KeptEdits kept;
    Progress progress;
    QVERIFY(evaluate("path", sources(), edits, context, progress, {&kept, {}}));
    context.conditions.feed *= 0.5;
    const auto slower = evaluate("path", sources(), edits, context, progress, {&kept, {}});
    const auto whole = evaluate("path", sources(), edits, context, progress);
    QVERIFY(slower && whole && alike(*slower, *whole));
    context.workOffset.x += 1.0;
    kept.begin(edits, context);
    QCOMPARE(kept.count(), std::size_t{0});
}

void TestKeptEdits::anotherObstacleOfTheSameExtentBeginsAnew() {
    const MeshDistance part{block};
    PathContext context = contextOf(part, ballTool(), {{-30, -30, -20}, {30, 30, 0}});
    context.obstacles = {{std::make_shared<const MeshDistance>(boxMesh({{-30, -30, 0}, {-22, -22, 8}}))}};
    const std::vector<Edit> edits = someEdits();
    KeptEdits kept;
    Progress progress;
    QVERIFY(evaluate("path", sources(), edits, context, progress, {&kept, {}}));
    context.obstacles = {{std::make_shared<const MeshDistance>(boxMesh({{-30, -30, 0}, {-22, -22, 8}}))}};
    kept.begin(edits, context); // a copy of it is the same obstacle
    QCOMPARE(kept.count(), edits.size() - 1);
    TriangleMesh posts = boxMesh({{-30, -30, 0}, {-28, -28, 8}});
    append(posts, boxMesh({{-24, -24, 0}, {-22, -22, 8}}));
    context.obstacles = {{std::make_shared<const MeshDistance>(posts)}};
    kept.begin(edits, context);
    QCOMPARE(kept.count(), std::size_t{0});
}

void TestKeptEdits::theFirstResultFollowsTheChangedEdit() {
    const MeshDistance part{block};
    const PathContext context = contextOf(part, ballTool(), {{-30, -30, -20}, {30, 30, 0}});
    std::vector<Edit> edits = someEdits();
    KeptEdits kept;
    Progress progress;
    int told = 0;
    std::size_t reports = 0;
    std::vector<PathPoint> points;
    const EvaluationHelp help{&kept, [&](const EvaluatedPath& path) {
                                  ++told;
                                  reports = path.reports.size();
                                  points = path.path.points;
                              }};
    QVERIFY(evaluate("path", sources(), edits, context, progress, help));
    QCOMPARE(told, 1);
    QCOMPARE(reports, std::size_t{1});
    std::get<MovePoints>(edits[2].parameters).by.y = 3.0;
    const auto path = evaluate("path", sources(), edits, context, progress, help);
    QVERIFY(path);
    QCOMPARE(told, 2);
    QCOMPARE(reports, std::size_t{3});
    // It has fewer points, and passes by all that it leaves out.
    const std::vector<Edit> first(edits.begin(), edits.begin() + 3);
    const auto whole = evaluate("path", sources(), first, context, progress);
    QVERIFY(whole && points.size() > 1);
    QVERIFY(points.size() < whole->path.points.size() / 2);
    std::size_t at = 1;
    for (const PathPoint& point : whole->path.points) {
        while (at + 1 < points.size() && points[at].sample < point.sample) ++at;
        double nearest = 1e300; // a sample is not always unique: edits insert points
        for (std::size_t i = at > 3 ? at - 3 : 1; i < std::min(at + 4, points.size()); ++i)
            nearest = std::min(nearest, distanceToSegment(point.pose.tip, points[i - 1].pose.tip, points[i].pose.tip));
        QVERIFY(nearest <= 0.01 + 1e-9);
    }
}

void TestKeptEdits::reportsAndTrailsCountAsMemory() {
    EditedState state;
    const std::vector<SourceStrokes> made = sources();
    state.path.hand = std::make_shared<const HandTrail>(made);
    for (const SourceStrokes& each : made)
        state.path.strokes.insert(state.path.strokes.end(), each.strokes.begin(), each.strokes.end());
    KeptEdits kept;
    QCOMPARE(kept.bytes(), std::size_t{0});
    kept.keep(1, state);
    const std::size_t alone = kept.bytes();
    QVERIFY(alone >= state.path.hand->bytes() + state.path.count() * sizeof(StrokePoint));
    EditReport report;
    report.inserted.assign(1000, glm::dvec3(0.0));
    report.omissions.push_back({OmissionReason::part, 1, 0, 9, std::vector<glm::dvec3>(500), 1.0});
    state.reports.push_back(report);
    kept.keep(2, state); // shares its trail with the first
    QVERIFY(kept.bytes() >= 2 * alone - state.path.hand->bytes() + 1500 * sizeof(glm::dvec3));
    QVERIFY(kept.bytes() < 2 * alone + 1700 * sizeof(glm::dvec3));
}

BURIN_TEST(TestKeptEdits, NoApplication)

} // namespace burin::tst_kept_edits

#include "tst_kept_edits.moc"
