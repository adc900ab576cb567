// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/program_job.h"
#include "tests/core/job/part_milling.h"
#include "tests/core/path/path_fixture.h"
#include "tests/oracles/canonical_program.h"
#include "tests/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <set>

namespace burin::tst_section_program {

using namespace burin::test;

namespace {

constexpr double from = -4.0, to = 3.0; // mm from program zero: the chosen part, along X

Tool flatTool() {
    Tool tool = sessionTool();
    tool.cutter.type = CutterType::flat;
    tool.cutter.cornerRadius = 0.0;
    tool.fluteCount = 2;
    return tool;
}

/// A cut of 16 mm along X, 1 mm deep, over the part; 0.05 mm per tick.
Result<EvaluatedPath> evaluated(const MillingContext& milling, const std::vector<Edit>& further) {
    StoredPath path;
    path.id = 1;
    path.sources = {{1}};
    path.edits = {{Simplify{}}, {FitArcs{}}, {Link{}}, {SetFeed{.cooling = SetFeed::Cooling::off}}};
    path.edits.insert(path.edits.end(), further.begin(), further.end());
    Take take = takeOf(along({{2, 10, 9}, {18, 10, 9}}, 50.0));
    take.info.toolId = milling.tool.id;
    Progress progress;
    return evaluateStored({*recordedStrokes(take)}, milling, milling.tool, path, {}, progress);
}

Result<CheckedProgram> posted(const MillingContext& milling, const std::vector<Edit>& further) {
    const Result<EvaluatedPath> path = evaluated(milling, further);
    if (!path) return path.error();
    ProgramRequest request;
    request.name = "section.ngc";
    Progress progress;
    return makeProgram(milling, path->path, request, progress);
}

/// The part of the path between both positions, at a lower speed and with coolant.
SpindleAndCoolant section() {
    const auto tickAt = [](double x) { return std::llround((x + 8.0) / 0.05); };
    return {{1, tickAt(from), tickAt(to)}, 5000.0, 1.0, SpindleAndCoolant::Cooling::flood};
}

} // namespace

/// Programs of a path of which a part has its own spindle speed and coolant.
class TestSectionProgram : public QObject {
    Q_OBJECT
private slots:
    /// LinuxCNC's interpreter uses the speed and coolant of the part between its ends, and those of the path elsewhere.
    void speedAndCoolantChangeAtTheBorders() {
        if (!CanonicalProgram::available()) QSKIP("rs274 (package linuxcnc-uspace) is not installed");
        const MillingContext milling = partMilling(flatTool());
        const Result<EvaluatedPath> path = evaluated(milling, {{section()}});
        const Result<CheckedProgram> program = posted(milling, {{section()}});
        QVERIFY2(program && path, program ? "" : program.error().subject.c_str());
        QVERIFY2(program->passed(), program->text.c_str());
        const CanonicalProgram truth = CanonicalProgram::ofText(program->text);
        QVERIFY2(truth.exitCode == 0, qPrintable(truth.complaint));
        std::vector<double> ends;
        for (std::size_t i = 1; i < truth.moves.size(); ++i) {
            const CanonicalMove& move = truth.moves[i];
            if (move.kind != CanonicalKind::line) continue;
            const double middle = 0.5 * (truth.moves[i - 1].to.x + move.to.x);
            const bool within = middle > from && middle < to;
            QCOMPARE(move.spindleSpeed, within ? 5000.0 : std::round(path->path.spindleSpeed));
            QCOMPARE(move.flood, within);
            QVERIFY(!move.mist);
            if (within) ends.push_back(move.to.x);
        }
        QVERIFY((ends == std::vector<double>{to}));
        QCOMPARE(std::ranges::count(truth.moves, CanonicalKind::dwell, &CanonicalMove::kind), 1); // only at the start
    }

    /// The same feed at a lower speed: the check computes the chip load from the spindle speed in force.
    void theCheckCountsWithTheSpeed() {
        const MillingContext milling = partMilling(flatTool());
        const Result<CheckedProgram> program = posted(milling, {{section()}});
        QVERIFY(program);
        std::set<bool> met;
        for (const MotionLoad& load : program->report.loads) {
            const NcMotion& motion = program->parsed.motions[load.motion];
            if (motion.kind != NcMotionKind::line || motion.to[Axis::z] != motion.from[Axis::z]) continue;
            const double fullChip = motion.feed / (2.0 * motion.spindleSpeed); // mm, with two teeth
            QVERIFY2(load.peak.feedPerTooth <= fullChip + 1e-9 && load.peak.feedPerTooth > 0.8 * fullChip,
                     qPrintable(QString("%1 of %2 mm").arg(load.peak.feedPerTooth).arg(fullChip)));
            met.insert(motion.spindleSpeed == 5000.0);
        }
        QCOMPARE(met.size(), std::size_t{2});
    }

    /// Feed by engagement after it limits the chip thickness at the spindle speed in force there.
    void feedsBehindItCountWithTheSpeed() {
        const MillingContext milling = partMilling(flatTool());
        FeedOptimisation level;
        level.goal = FeedOptimisation::Goal::removal;
        level.target = 1e5; // mm³/s: never reached, so that the chip is the limit
        level.largestChip = 0.01;
        const Result<EvaluatedPath> path = evaluated(milling, {{section()}, {level}});
        QVERIFY(path);
        std::set<bool> met;
        for (const PathPoint& point : path->path.points) {
            if (point.kind != MoveKind::cut) continue;
            const double speed = point.spindleSpeed > 0.0 ? point.spindleSpeed : path->path.spindleSpeed;
            QVERIFY(point.feed <= 2.0 * speed * level.largestChip + 1e-6);
            QCOMPARE(point.coolant.has_value(), point.spindleSpeed == 5000.0);
            met.insert(point.coolant.has_value());
        }
        QCOMPARE(met.size(), std::size_t{2});
    }

    /// If it is switched off or keeps both values, the text is byte for byte that of the path without it.
    void withoutItTheTextStays() {
        const MillingContext milling = partMilling(flatTool());
        const Result<CheckedProgram> plain = posted(milling, {});
        QVERIFY(plain);
        for (const Edit& edit : {Edit{section(), false}, Edit{SpindleAndCoolant{}, true}}) {
            const Result<CheckedProgram> other = posted(milling, {edit});
            QVERIFY(other);
            QCOMPARE(other->text, plain->text);
        }
    }
};

BURIN_TEST(TestSectionProgram, NoApplication)

} // namespace burin::tst_section_program

#include "tst_section_program.moc"
