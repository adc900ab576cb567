// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/lower_feeds.h"
#include "tests/core/job/part_milling.h"
#include "tests/core/path/path_fixture.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QCoreApplication>
#include <QtTest>

#include <cmath>

namespace burin::tst_lower_feeds {

using namespace burin::test;

namespace {

Tool endMill() {
    Tool tool = flatTool(6.0);
    tool.source = "made up";
    tool.fluteCount = 3;
    tool.centreCutting = true;
    tool.maximumDepthOfCut = 9.0;
    return tool;
}

MillingContext aluminiumMilling(double spindlePower) {
    Setup setup = blockSetup();
    setup.stockMaterial = "aluminium-6061";
    MillingContext milling = partMilling(endMill(), setup);
    milling.machine.spindlePower = spindlePower;
    milling.machine.spindleTorque.clear();
    return milling;
}

/// A program of one recording along a polyline above the part, with or without feed optimisation.
Result<CheckedProgram> programOf(const MillingContext& milling, const std::vector<glm::dvec3>& corners,
                                 bool byEngagement) {
    std::vector<Edit> edits{{Simplify{}}, {Link{.entry = Link::Entry::ramp}}, {SetFeed{}}};
    if (byEngagement) edits.push_back({FeedOptimisation{.goal = FeedOptimisation::Goal::limits}});
    StoredPath stored;
    stored.edits = std::move(edits);
    Take take = takeOf(along(corners, 50.0));
    take.info.toolId = milling.tool.id;
    Progress progress;
    const Result<EvaluatedPath> path =
        evaluateStored({*recordedStrokes(take)}, milling, milling.tool, stored, {}, progress);
    if (!path) return path.error();
    ProgramRequest request;
    request.name = "test";
    return makeProgram(milling, path->path, request, progress);
}

bool asksTooMuch(const CheckedProgram& program) {
    return std::ranges::any_of(program.report.findings,
                               [](const Finding& one) { return one.kind == FindingKind::spindlePower; });
}

/// Whether a move that exceeds the power could be fed slower: none of its chips is at the edit's lower limit.
bool couldBeSlower(const CheckedProgram& program) {
    return std::ranges::any_of(program.report.findings, [&](const Finding& finding) {
        if (finding.kind != FindingKind::spindlePower) return false;
        return std::ranges::any_of(program.parsed.motions, [&](const NcMotion& motion) {
            const double chip = motion.spindleSpeed > 0.0 ? motion.feed / (3.0 * motion.spindleSpeed) : 0.0; // 3 teeth
            return motion.line == finding.line && chip > 1.001 * FeedOptimisation{}.smallestChip;
        });
    });
}

glm::dvec3 placeInTheBlock() {
    const auto within = [](int low, int high) { return 0.1 * *rc::gen::inRange(low, high); };
    return {within(-40, 240), within(-40, 240), within(81, 101)};
}

} // namespace

class TestLowerFeeds : public QObject {
    Q_OBJECT
private slots:
    /// The edit's coarse estimate misses loads; the posted program is right nevertheless.
    void noProgramAsksForMorePowerThanThereIs() {
        int refusedWithout = 0, lowered = 0, passed = 0;
        QVERIFY(rc::check("whatever the hand did", [&] {
            std::vector<glm::dvec3> corners;
            const int count = *rc::gen::inRange(3, 7);
            for (int i = 0; i < count; ++i) corners.push_back(placeInTheBlock());
            const MillingContext milling = aluminiumMilling(*rc::gen::inRange(480, 700));
            const Result<CheckedProgram> free = programOf(milling, corners, false);
            const Result<CheckedProgram> held = programOf(milling, corners, true);
            RC_ASSERT(free.hasValue() && held.hasValue());
            refusedWithout += asksTooMuch(*free) ? 1 : 0;
            lowered += held->slowed > 0 ? 1 : 0;
            RC_ASSERT(free->slowed == 0U);
            RC_ASSERT(!couldBeSlower(*held));
            passed += asksTooMuch(*held) ? 0 : 1;
            RC_ASSERT(held->parsed.motions.size() >= free->parsed.motions.size()); // nothing is left out because of it
        }));
        QVERIFY2(refusedWithout > 15 && lowered > 5 && passed > 90,
                 qPrintable(QString("%1 %2 %3").arg(refusedWithout).arg(lowered).arg(passed)));
    }

    void feedsComeDownToWhatIsBorneAndNoLower() {
        Path free, held;
        held.leastFeed = 300.0;
        const auto line = [](double x, double y, double feed) {
            return PathPoint{{{x, y, 0.0}}, feed > 0.0 ? MoveKind::cut : MoveKind::rapid, feed};
        };
        held.points = {line(0, 0, 0.0), line(10, 0, 1000.0), line(20, 0, 1000.0), line(30, 0, 1000.0)};
        free.points = {line(30, 5, 0.0), line(40, 5, 1000.0)};
        ParsedProgram program;
        const auto motion = [&](double x, double y) {
            NcMotion one;
            one.to = {x, y, 0.0};
            program.motions.push_back(one);
        };
        motion(0, 0);
        motion(10, 0);
        motion(15, 0); // half of the next move, which the control split
        motion(20, 0);
        motion(30, 0);
        motion(30, 5);
        motion(40, 5);
        std::vector<Path> paths{held, free};
        QCOMPARE(lowerFeeds(paths, program, {{2, 600.0}, {4, 100.0}, {6, 500.0}}, ThreeAxes()), std::size_t(2));
        const auto feed = [&](std::size_t path, std::size_t point) { return paths[path].points[point].feed; };
        QCOMPARE(feed(0, 1), 1000.0);
        QVERIFY(feed(0, 2) <= 600.0 && feed(0, 2) > 580.0);
        QCOMPARE(feed(0, 3), 300.0);  // no chip is thinner than the edit permits
        QCOMPARE(feed(1, 1), 1000.0); // its list has no such edit
        QCOMPARE(lowerFeeds(paths, program, {{1, 2000.0}}, ThreeAxes()), std::size_t(0));
    }
};

BURIN_TEST(TestLowerFeeds, QCoreApplication)

} // namespace burin::tst_lower_feeds

#include "tst_lower_feeds.moc"
