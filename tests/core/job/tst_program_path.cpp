// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/program_job.h"
#include "core/job/program_path.h"
#include "core/nc/apt_reader.h"
#include "core/nc/parser.h"
#include "core/path/hand_interval.h"
#include "tests/core/job/session_milling.h"
#include "tests/oracles/canonical_program.h"
#include "tests/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin::tst_program_path {

using namespace burin::test;

namespace {

constexpr const char* job =
    "G21 G90 G17 G94 G54\nT4 M6\nM3 S10000\nG0 X-14 Y0\nZ2\nG1 Z-1.5 F300\nX8 F600\n"
    "G3 X0 Y8 I-8 J0 F450\nG4 P0.5\nS8000\nG1 X-14 F700\nG0 Z5\nX-14 Y6\nG1 Z-0.5 F250\nX14 F900\n"
    "G0 Z5\nM2\n";

/// The same job as a CAM system passes it to its post-processor.
constexpr const char* locations =
    "PARTNO SLOT\n$$ by hand\nUNITS / MM\nCUTTER/ 4.0, 2.0\nLOADTL/ 4\nSPINDL/ 10000, RPM, CLW\n"
    "RAPID\nGOTO/ -14, 0, 2\nFEDRAT/ 300, MMPM\nGOTO/ -14, 0, -1.5\nFEDRAT/ 600, MMPM\n"
    "GOTO/ 8.0, 0.0, -1.5, 0, 0, 1\nFEDRAT/ 450, MMPM\nCIRCLE/ 0, 0, -1.5, $\n 0, 0, 1, 8\n"
    "GOTO/ 0, 8, -1.5\nSPINDL/ 8000, RPM, CLW\nFEDRAT/ 700, MMPM\nGODLTA/ -14, 0, 0\nRAPID\n"
    "GOTO/ -14, 8, 5\nRAPID\nGOTO/ -14, 6, 5\nFEDRAT/ 250, MMPM\nGOTO/ -14, 6, -0.5\n"
    "FEDRAT/ 900, MMPM\nGOTO/ 14, 6, -0.5\nRAPID\nGODLTA/ 5.5\nFINI\nGOTO/ nothing\n";

ProgramPasses passesOf(const std::string& text, const MillingContext& milling) {
    Progress progress;
    const ToolChoice tools{{sessionTool()}, true};
    Result<ProgramPasses> passes = passesOfProgram(text, "slot.ngc", "linuxcnc", milling, tools, progress);
    if (!passes) qFatal("%s: %s", passes.error().subject.c_str(), passes.error().detail.c_str());
    return std::move(*passes);
}

EvaluatedPath evaluated(const ProgramPasses& passes, const std::vector<Edit>& edits, const MillingContext& milling) {
    StoredPath path{1, "slot", {{-1}}, edits};
    std::vector<SourceStrokes> strokes;
    GeneratedMoves moves = passes.passes.front().moves;
    moves.info.id = -1;
    strokes.push_back(*strokesOf(moves));
    Progress progress;
    Result<EvaluatedPath> made = evaluateStored(std::move(strokes), milling, milling.tool, path, {}, progress);
    if (!made) qFatal("%s %s", made.error().subject.c_str(), made.error().detail.c_str());
    return std::move(*made);
}

/// Cutting moves at feed rate of a program's text.
std::vector<NcMotion> cuts(const ParsedProgram& program) {
    std::vector<NcMotion> all;
    for (const NcMotion& motion : program.motions)
        if (motion.kind == NcMotionKind::arc || (motion.kind == NcMotionKind::line && motion.to.linear().z < 0.0 &&
                                                 std::abs(motion.to.linear().z - motion.from.linear().z) < 1e-9))
            all.push_back(motion);
    return all;
}

Error refusalOf(const std::string& text) {
    const Result<ParsedProgram> program = parseCutterLocations(text, "a.cls");
    return program ? Error{} : program.error();
}

} // namespace

class TestProgramPath : public QObject {
    Q_OBJECT
private slots:
    /// Posted again, the program has its original moves, feeds and speeds, as shown by its own text.
    void aProgramComesOutAsItWentIn() {
        const ProgramPasses passes = passesOf(job, milling_);
        QCOMPARE(passes.arcs, std::size_t{1});
        QCOMPARE(passes.dwells, std::size_t{1});
        QCOMPARE(passes.startless, std::size_t{0});
        // 3.5 + 22 + a quarter of a circle + 14, then 5.5 + 28 mm; chords of 0.001 mm are a little shorter than their
        // arc.
        const double way = 3.5 + 22.0 + 0.5 * std::acos(-1.0) * 8.0 + 14.0 + 5.5 + 28.0;
        QVERIFY2(passes.passes.front().length < way && passes.passes.front().length > way - 0.02,
                 qPrintable(QString::number(passes.passes.front().length - way)));
        const StoredPath stored = withProgram({}, "slot.ngc", PassUse{}, -1);
        const EvaluatedPath path = evaluated(passes, stored.edits, milling_);
        ProgramRequest request;
        request.name = "slot";
        Progress progress;
        const Result<CheckedProgram> posted = makeProgram(milling_, path.path, request, progress);
        QVERIFY(posted);
        const std::vector<NcMotion> wanted = cuts(*parseProgram(job, "slot.ngc")), found = cuts(posted->parsed);
        QCOMPARE(found.size(), wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            QVERIFY2(glm::distance(found[i].to.linear(), wanted[i].to.linear()) < 0.0015,
                     qPrintable(QString::number(i)));
            QCOMPARE(static_cast<int>(found[i].kind), static_cast<int>(wanted[i].kind));
            QVERIFY2(std::abs(found[i].feed - wanted[i].feed) < 0.6, qPrintable(QString::number(found[i].feed)));
            QCOMPARE(found[i].spindleSpeed, wanted[i].spindleSpeed);
            if (wanted[i].kind == NcMotionKind::arc)
                QVERIFY(glm::distance(glm::dvec2(found[i].centre), glm::dvec2(wanted[i].centre)) < 0.003);
        }
    }

    void cutterLocationsAreTheSameMoves() {
        QVERIFY(isCutterLocations(locations) && !isCutterLocations(job));
        const ProgramPasses code = passesOf(job, milling_), made = passesOf(locations, milling_);
        QCOMPARE(made.passes.size(), std::size_t{1});
        const auto& wanted = code.passes.front().moves.strokes;
        const auto& found = made.passes.front().moves.strokes;
        QCOMPARE(found.size(), wanted.size());
        for (std::size_t s = 0; s < wanted.size(); ++s) {
            QCOMPARE(found[s].size(), wanted[s].size());
            for (std::size_t i = 0; i < wanted[s].size(); ++i) {
                QVERIFY(glm::distance(found[s][i].pose.tip, wanted[s][i].pose.tip) < 1e-9);
                QCOMPARE(found[s][i].feed, wanted[s][i].feed);
                QCOMPARE(found[s][i].spindleSpeed, wanted[s][i].spindleSpeed);
            }
        }
    }

    void inchesAndFeedsPerTurnAreRead() {
        const auto program =
            parseCutterLocations("UNITS/INCHES\nSPINDL/RPM, 1000, CCLW\nFEDRAT/0.002, IPR\nFROM/0,0,0\n"
                                 "GOTO/1,0,0\nFEDRAT/10,IPM\nGOTO/2,0,0\nFEDRAT/100,MMPM\nGOTO/3,0,0\n",
                                 "a.cls");
        QVERIFY(program);
        QCOMPARE(program->motions.size(), std::size_t{3});
        QCOMPARE(program->motions[0].to.linear().x, 25.4);
        QVERIFY(std::abs(program->motions[0].feed - 50.8) < 1e-9);
        QVERIFY(std::abs(program->motions[1].feed - 254.0) < 1e-9);
        QCOMPARE(program->motions[2].feed, 100.0);
        QCOMPARE(program->motions[2].spindle, SpindleState::anticlockwise);
    }

    /// Words that would move the machine differently are refused, with their line.
    void whatCannotBeFollowedIsRefused_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("place");
        QTest::newRow("tilted") << "FEDRAT/100\nGOTO/0,0,0\nGOTO/1,0,0,0.1,0,0.995\n"
                                << "line 3";
        QTest::newRow("axis") << "TLAXIS/0,1,0\n"
                              << "line 1";
        QTest::newRow("cycle") << "FEDRAT/100\nCYCLE/DRILL,5,100,MMPM,2\n"
                               << "line 2";
        QTest::newRow("compensation") << "\nCUTCOM/LEFT\n"
                                      << "line 2";
        QTest::newRow("no feed") << "GOTO/0,0,0\n"
                                 << "line 1";
        QTest::newRow("numbers") << "FEDRAT/1\nGOTO/0,0\n"
                                 << "line 2";
        QTest::newRow("no number") << "FEDRAT/1\nGOTO/0,0,nan\n"
                                   << "line 2";
        QTest::newRow("circle") << "FEDRAT/1\nGOTO/0,0,0\nCIRCLE/5,0,0,0,0,1,4\nGOTO/10,0,0\n"
                                << "line 4";
        QTest::newRow("upright circle") << "FEDRAT/1\nGOTO/0,0,0\nCIRCLE/5,0,0,0,1,0,5\n"
                                        << "line 3";
        QTest::newRow("surface speed") << "SPINDL/300,SFM\n"
                                       << "line 1";
        QTest::newRow("far away") << "FEDRAT/1\nGOTO/0,0,1e308\n"
                                  << "line 2";
        QTest::newRow("unknown") << "WHATEVER/1,2\n"
                                 << "line 1";
    }
    void whatCannotBeFollowedIsRefused() {
        QFETCH(QString, text);
        QFETCH(QString, place);
        const Error error = refusalOf(text.toStdString());
        QCOMPARE(error.code, ErrorCode::programSyntax);
        QCOMPARE(QString::fromStdString(error.place), place);
        QVERIFY(!error.detail.empty());
    }

    /// Where an edit joins several moves, the result has the lowest of their feeds.
    void oneMoveOfSeveralIsFedAsTheSlowest() {
        const ProgramPasses passes =
            passesOf("G21 G90 G94 G54\nS9000 M3\nG0 X-14 Y0 Z2\nG1 Z-1 F200\nX-6 F600\nX2 F350\n"
                     "X10 F600\nG0 Z5\nM2\n",
                     milling_);
        std::vector<Edit> edits = programEdits();
        edits.insert(edits.begin(), {Simplify{}});
        const EvaluatedPath path = evaluated(passes, edits, milling_);
        std::vector<double> feeds;
        for (const PathPoint& point : path.path.points)
            if (point.kind == MoveKind::cut && hasMoment(point) &&
                point.pose.tip.x > milling_.setup.workOffset.x - 13.0)
                feeds.push_back(point.feed);
        QCOMPARE(feeds, std::vector{350.0});
        QCOMPARE(path.path.spindleSpeed, 9000.0);
    }

    /// A faster machine would be needed: the chip load is kept, and the feed is the machine's limit.
    void machineAndToolLimitWhatIsStated() {
        const ProgramPasses passes =
            passesOf("G21 G90 G94 G54\nS40000 M3\nG0 X-14 Y0 Z2\nG1 Z-1 F200\nX10 F1000\nG0 Z5\nM2\n", milling_);
        const EvaluatedPath path = evaluated(passes, programEdits(), milling_);
        double limit = sessionTool().maximumSpindleSpeed;
        if (milling_.machine.maximumSpindleSpeed > 0.0) limit = std::min(limit, milling_.machine.maximumSpindleSpeed);
        QCOMPARE(path.path.spindleSpeed, limit);
        const PathPoint& last = *std::ranges::find_if(path.path.points, [&](const PathPoint& point) {
            return point.kind == MoveKind::cut && point.pose.tip.x > milling_.setup.workOffset.x + 9.0;
        });
        QVERIFY(std::abs(last.feed - 1000.0 * limit / 40000.0) < 1e-9);
    }

    void eachToolHasItsPass() {
        Tool other = sessionTool();
        other.id = "ball-6";
        other.number = 7;
        Tool first = sessionTool();
        first.number = 3;
        const std::string text =
            "G21 G90 G94 G54\nT3 M6\nS9000 M3 M8\nG0 X0 Y0 Z2\nG1 Z-1 F200\nG0 Z9\nT7 M6\nS9000 M3 M9\n"
            "G0 X5 Y0 Z2\nG1 Z-1 F200\nG0 Z9\nT3 M6\nS9000 M3\nG0 X9 Y0 Z2\nG1 Z-1 F200\nM2\n";
        Progress progress;
        const auto passes = passesOfProgram(text, "/somewhere/two.ngc", "linuxcnc", milling_,
                                            ToolChoice{{first, other}, false}, progress);
        QVERIFY(passes);
        QCOMPARE(passes->passes.size(), std::size_t{3});
        QCOMPARE(passes->passes[1].tool.id, std::string("ball-6"));
        QCOMPARE(passes->passes[2].moves.info.toolId, first.id);
        QCOMPARE(passes->passes[0].moves.info.name, std::string("two.ngc"));
        QCOMPARE(static_cast<int>(passes->passes[0].coolant), static_cast<int>(Coolant::flood));
        QCOMPARE(static_cast<int>(passes->passes[1].coolant), static_cast<int>(Coolant::off));
        // With a tool selected for programs with a single tool number, this program still uses its own; a program with
        // a single number uses that tool.
        const ToolChoice loaded{{first, other}, false, sessionTool()};
        const auto own = passesOfProgram(text, "two.ngc", "linuxcnc", milling_, loaded, progress);
        QVERIFY(own && own->passes.size() == 3 && own->passes[1].tool.id == "ball-6");
        const auto only = passesOfProgram(job, "one.ngc", "linuxcnc", milling_, loaded, progress); // T4
        QVERIFY(only && only->passes.size() == 1);
        QCOMPARE(only->passes[0].tool.id, sessionTool().id);
        other.number = 8;
        const auto unknown =
            passesOfProgram(text, "two.ngc", "linuxcnc", milling_, ToolChoice{{first, other}, false}, progress);
        QCOMPARE(unknown.error().code, ErrorCode::nameUnknown);
        QCOMPARE(unknown.error().place, std::string("T7"));
    }

    /// A path made of a program that cuts dry, with mist and with flood switches the coolant at the same positions, as
    /// LinuxCNC's interpreter reads it from the program posted; a link has the coolant of the cut that follows it.
    void eachCutKeepsItsCoolant() {
        if (!CanonicalProgram::available()) QSKIP("rs274 (package linuxcnc-uspace) is not installed");
        const std::string text = "G21 G90 G94 G54\nT4 M6\nS9000 M3\nG0 X-14 Y0 Z2\nG1 Z-1 F200\nX-10\nM7\nX-2\nM9\nM8\n"
                                 "X6\nG0 Z5\nX-14 Y6\nM9\nG1 Z-1\nX3\nM7\nX9\nM2\n";
        const ProgramPasses passes = passesOf(text, milling_);
        const StoredPath stored = withProgram({}, "slot.ngc", useOf(passes.passes.front()), -1);
        const EvaluatedPath path = evaluated(passes, stored.edits, milling_);
        ProgramRequest request;
        request.name = "slot";
        Progress progress;
        const Result<CheckedProgram> posted = makeProgram(milling_, path.path, request, progress);
        QVERIFY2(posted, posted ? "" : posted.error().subject.c_str());
        const CanonicalProgram truth = CanonicalProgram::ofText(posted->text);
        QVERIFY2(truth.exitCode == 0, qPrintable(truth.complaint));
        std::vector<std::pair<double, Coolant>> ends; // X at the end of each level cut, and its coolant
        glm::dvec3 at(0.0);
        for (const CanonicalMove& move : truth.moves) {
            if (move.kind == CanonicalKind::dwell) continue;
            if (move.kind == CanonicalKind::line && std::abs(move.to.z - at.z) < 1e-6 && move.to.z < 0.0)
                ends.emplace_back(move.to.x, move.flood ? Coolant::flood : move.mist ? Coolant::mist : Coolant::off);
            at = move.to;
        }
        const std::vector<std::pair<double, Coolant>> wanted{{-10.0, Coolant::off},
                                                             {-2.0, Coolant::mist},
                                                             {6.0, Coolant::flood},
                                                             {3.0, Coolant::off},
                                                             {9.0, Coolant::mist}};
        QCOMPARE(ends.size(), wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            QVERIFY(std::abs(ends[i].first - wanted[i].first) < 0.002);
            QCOMPARE(static_cast<int>(ends[i].second), static_cast<int>(wanted[i].second));
        }
    }

    /// A coolant that the machine lacks is refused, as one that was requested by its name is.
    void aCoolantThatTheMachineLacksIsRefused() {
        const ProgramPasses passes =
            passesOf("G21 G90 G94 G54\nS9000 M3\nG0 X-14 Y0 Z2\nM8\nG1 Z-1 F200\nX0\nM9\nM7\nX8\nM2\n", milling_);
        MillingContext dry = blockMilling();
        dry.machine.coolants = std::vector<Coolant>{Coolant::flood};
        GeneratedMoves moves = passes.passes.front().moves;
        moves.info.id = -1;
        const StoredPath stored = withProgram({}, "slot.ngc", useOf(passes.passes.front()), -1);
        Progress progress;
        const auto made = evaluateStored({*strokesOf(moves)}, dry, dry.tool, stored, {}, progress);
        QCOMPARE(made.error().code, ErrorCode::notSupported);
    }

    /// A pass that cuts dry, with mist and with flood counts once. Coolant that is switched while the tool moves at
    /// rapid, and switched back, changes nothing.
    void changesOfCoolantAreCounted() {
        const auto changes = [&](const std::string& cut) {
            const ProgramPasses passes =
                passesOf("G21 G90 G94 G54\nS9000 M3\nG0 X-14 Y0 Z2\n" + cut + "M2\n", milling_);
            return std::pair(passes.coolantChanges(), passes.passes.front().coolant);
        };
        QVERIFY(changes("G1 Z-1 F200\nX0\nX8\n") == std::pair(std::size_t{0}, Coolant::off));
        QVERIFY(changes("M8\nG1 Z-1 F200\nX0\nM9\nG0 Z2\nX2\nM8\nG1 Z-1\n") ==
                std::pair(std::size_t{0}, Coolant::flood));
        QVERIFY(changes("G1 Z-1 F200\nM7\nX0\nM9\nM8\nX8\n") == std::pair(std::size_t{1}, Coolant::mist));
        QVERIFY(changes("M8\nG1 Z-1 F200\nM9\nX8\n") == std::pair(std::size_t{1}, Coolant::flood));
    }

    void whatNoPathCanHoldIsRefused() {
        Progress progress;
        const ToolChoice tools{{sessionTool()}, true};
        const auto errorOf = [&](const std::string& text) {
            const auto passes = passesOfProgram(text, "a.ngc", "linuxcnc", milling_, tools, progress);
            return passes ? Error{} : passes.error();
        };
        QCOMPARE(errorOf("G21 G90 G94\nG0 X1 Y1 Z1\nM2\n").code, ErrorCode::pathEmpty);
        const Error offsets = errorOf("G21 G90 G94 G54\nG0 X1 Y1 Z1\nG1 X2 F100\nG55\nG0 X1 Y1 Z1\nG1 X2\nM2\n");
        QCOMPARE(offsets.code, ErrorCode::programSyntax);
        QCOMPARE(offsets.place, std::string("line 5"));
        // Chords of such arcs would exceed the memory.
        std::string far = "G21 G90 G94 G54 G17\nG0 X0 Y0 Z0\n";
        for (int i = 0; i < 20; ++i) far += "G2 X0 Y0 I90000 J0 F100\n";
        QCOMPARE(errorOf(far + "M2\n").code, ErrorCode::programSyntax);
    }

private:
    MillingContext milling_ = blockMilling();
};

BURIN_TEST(TestProgramPath, QCoreApplication)

} // namespace burin::tst_program_path

#include "tst_program_path.moc"
