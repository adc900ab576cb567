// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/program_job.h"
#include "core/job/program_path.h"
#include "core/machine/kinematics.h"
#include "core/machine/machine_library.h"
#include "core/nc/apt_reader.h"
#include "tests/core/geometry/shapes.h"
#include "tests/core/job/session_milling.h"
#include "tests/core/path/path_fixture.h"
#include "tests/oracles/canonical_program.h"
#include "tests/test_program.h"

#include <glm/gtc/matrix_transform.hpp>

#include <QtTest>

namespace burin::tst_tilted_program {

using namespace burin::test;

namespace {

constexpr double degree = pi / 180.0;
constexpr const char* fiveAxes = "linuxcnc-five-axis"; // a table that turns about A and C

/// The block with a smaller one in it as the part, on a machine whose table tilts.
MillingContext tiltingMilling() {
    Body body;
    body.name = "block";
    body.box = {{6.0, 6.0, 1.0}, {14.0, 14.0, 8.0}};
    body.mesh = shapes::box(body.box.low, body.box.high);
    Model model;
    model.bodies = {body};
    Progress progress;
    Result<MillingContext> milling = makeMillingContext(
        {std::make_shared<const Model>(model), blockSetup(), sessionTool(), fiveAxes, {}, {}}, progress);
    if (!milling) qFatal("%s %s", milling.error().subject.c_str(), milling.error().place.c_str());
    return std::move(*milling);
}

/// The tool's direction on the workpiece for a table that turns right-handed by A about X, and on it by C about Z.
glm::dvec3 directionOf(double a, double c) {
    const glm::dmat4 table = glm::rotate(glm::rotate(glm::dmat4(1.0), a * degree, {1, 0, 0}), c * degree, {0, 0, 1});
    return glm::dvec3(glm::transpose(table) * glm::dvec4(0.0, 0.0, 1.0, 0.0));
}

/// A cut of 16 mm along X, 1.5 mm deep, over the part, of which a part is tilted.
Result<EvaluatedPath> evaluated(const MillingContext& milling, const std::vector<Edit>& further) {
    StoredPath path;
    path.id = 1;
    path.sources = {{1}};
    path.edits = {{Simplify{}}, {FitArcs{}}, {Link{}}, {SetFeed{.cooling = SetFeed::Cooling::off}}};
    path.edits.insert(path.edits.end(), further.begin(), further.end());
    Take take = takeOf(along({{2, 10, 8.5}, {18, 10, 8.5}}, 50.0));
    take.info.toolId = milling.tool.id;
    Progress progress;
    return evaluateStored({*recordedStrokes(take)}, milling, milling.tool, path, {}, progress);
}

Result<CheckedProgram> posted(const MillingContext& milling, const EvaluatedPath& path) {
    ProgramRequest request;
    request.name = "tilted";
    Progress progress;
    return makeProgram(milling, path.path, request, progress);
}

ToolAxis leaning() {
    ToolAxis axis;
    axis.interval = {1, 100, 220}; // 5 to 11 mm of the cut
    axis.lead = 10.0 * degree;
    axis.tilt = 15.0 * degree;
    axis.blend = 2.0;
    return axis;
}

constexpr const char* job =
    "G21 G90 G17 G94 G54\nT4 M6\nM3 S10000\nG0 A0 C0 X-8 Y0\nZ20\nA20 C30\nG0 Z2\nG1 Z-1 F300\nX0 F600\n"
    "X4 A25 C60 F500\nX6 Y2\nX6.5 Y3 A10 C75\nG0 Z20\nX-8 Y5 A0 C0\nZ2\nG1 Z-0.5 F200\nX8 F700\n"
    "G0 Z20\nM2\n";

std::vector<NcMotion> cuts(const ParsedProgram& program) {
    std::vector<NcMotion> all;
    for (const NcMotion& motion : program.motions)
        if (motion.kind == NcMotionKind::line && motion.from.linear() != motion.to.linear()) all.push_back(motion);
    return all;
}

ProgramPasses passesOf(const std::string& text, const MillingContext& milling) {
    Progress progress;
    Result<ProgramPasses> passes =
        passesOfProgram(text, "tilted.ngc", "linuxcnc", milling, ToolChoice{{sessionTool()}, true}, progress);
    if (!passes) qFatal("%s: %s", passes.error().place.c_str(), passes.error().detail.c_str());
    return std::move(*passes);
}

/// The centre of the ball, with its direction, at the end of each cut that moves the tip.
std::vector<ToolPose> centres(const CanonicalProgram& program) {
    std::vector<ToolPose> all;
    glm::dvec3 at(0.0);
    for (const CanonicalMove& move : program.moves) {
        const glm::dvec3 axis = directionOf(move.rotary.x, move.rotary.z);
        if (move.kind == CanonicalKind::line && move.to != at) all.push_back({move.to + 2.0 * axis, axis});
        at = move.to;
    }
    return all;
}

/// Points 0.05 mm apart on the part's top and front face, up to 1 mm from the edge between them.
std::vector<glm::dvec3> cornerOfThePart() {
    std::vector<glm::dvec3> points;
    for (int x = 0; x <= 160; ++x)
        for (int d = 0; d <= 20; ++d) {
            points.emplace_back(6.0 + 0.05 * x, 6.0 + 0.05 * d, 8.0);
            points.emplace_back(6.0 + 0.05 * x, 6.0, 8.0 - 0.05 * d);
        }
    return points;
}

Result<EvaluatedPath> pathOf(const ProgramPasses& passes, const MillingContext& milling) {
    const StoredPath stored = withProgram({}, "tilted.ngc", useOf(passes.passes.front()), -1);
    GeneratedMoves moves = passes.passes.front().moves;
    moves.info.id = -1;
    Progress progress;
    return evaluateStored({*strokesOf(moves)}, milling, milling.tool, stored, {}, progress);
}

} // namespace

/// Paths of a tilted tool, from the edit to the program that was read back, and from a program to a path.
class TestTiltedProgram : public QObject {
    Q_OBJECT
private slots:
    /// LinuxCNC's interpreter reads values of the axes from which matrices make the poses of the path; the check finds
    /// nothing wrong, and the ball cuts what it cuts upright, except for its flanks.
    void aTiltedPartIsPostedAndRead() {
        const MillingContext milling = tiltingMilling();
        const auto path = evaluated(milling, {{leaning()}});
        QVERIFY2(path, path ? "" : (path.error().subject + path.error().place).c_str());
        const auto program = posted(milling, *path);
        QVERIFY2(program, program ? "" : (program.error().subject + program.error().place).c_str());
        QVERIFY2(program->passed(), program->text.c_str());
        const auto upright = evaluated(milling, {});
        const auto plain = posted(milling, *upright);
        QVERIFY(plain && plain->passed());
        QVERIFY2(std::abs(program->report.removed - plain->report.removed) < 0.02 * plain->report.removed,
                 qPrintable(QString("%1 %2").arg(program->report.removed).arg(plain->report.removed)));
        if (!CanonicalProgram::available()) QSKIP("rs274 (package linuxcnc-uspace) is not installed");
        const CanonicalProgram truth = CanonicalProgram::ofText(program->text);
        QVERIFY2(truth.exitCode == 0, qPrintable(truth.complaint));
        std::size_t next = 0, tilted = 0;
        for (const CanonicalMove& move : truth.moves) {
            if (move.kind != CanonicalKind::line) continue;
            const glm::dvec3 tip = move.to + milling.setup.workOffset;
            while (next < path->path.points.size() && glm::distance(path->path.points[next].pose.tip, tip) > 0.0015)
                ++next;
            QVERIFY2(next < path->path.points.size(), "a move that the path does not have");
            const glm::dvec3& axis = path->path.points[next].pose.axis;
            QVERIFY(glm::distance(directionOf(move.rotary.x, move.rotary.z), axis) < 5e-6);
            tilted += axis.z < 0.999 ? 1 : 0;
        }
        QVERIFY(tilted > 10);
    }

    /// What the program's text says, by brute force: at no pose, as the axes turn between blocks, the tool is in the
    /// part.
    void noPoseOfTheProgramIsInThePart() {
        const MillingContext milling = tiltingMilling();
        const auto path = evaluated(milling, {{leaning()}});
        const auto program = posted(milling, *path);
        QVERIFY(program);
        const std::vector<RevolvedPiece> tool = pieces(milling.tool.cutter);
        int looked = 0;
        for (const NcMotion& motion : program->parsed.motions) {
            if (motion.kind == NcMotionKind::dwell || !motion.startKnown()) continue;
            for (int k = 0; k <= 16; ++k) {
                const double share = k / 16.0;
                const auto at = [&](Axis axis) { return glm::mix(motion.from[axis], motion.to[axis], share); };
                const glm::dvec3 tip(at(Axis::x), at(Axis::y), at(Axis::z));
                const ToolPose pose{tip + milling.setup.workOffset, directionOf(at(Axis::a), at(Axis::c))};
                QVERIFY(milling.part.clearance(tool, pose, 3.0).clearance > -0.002);
                ++looked;
            }
        }
        QVERIFY(looked > 100);
    }

    /// A path made of a program whose axes tilt, and change while it cuts, has the program's own moves when it is
    /// posted.
    void aTiltedProgramComesOutAsItWentIn() {
        const MillingContext milling = tiltingMilling();
        const ProgramPasses passes = passesOf(job, milling);
        QVERIFY(passes.passes.front().tilted);
        const auto path = pathOf(passes, milling);
        QVERIFY2(path, path ? "" : (path.error().subject + path.error().place).c_str());
        const auto program = posted(milling, *path);
        QVERIFY2(program, program ? "" : (program.error().subject + program.error().place).c_str());
        const Control& control = withRotaryAxes(defaultControl(), milling.machine.axes());
        const std::vector<NcMotion> wanted = cuts(*parseProgram(job, "job", control));
        std::vector<NcMotion> found = cuts(program->parsed);
        std::size_t next = 0;
        for (const NcMotion& motion : wanted) {
            const auto same = [&](const NcMotion& other) {
                return glm::distance(other.to.linear(), motion.to.linear()) < 0.0015;
            };
            while (next < found.size() && !same(found[next])) ++next;
            QVERIFY2(next < found.size(), program->text.c_str());
            const ToolPose pose = kinematicsOf(milling.machine, {})->poseOf(found[next].to);
            QVERIFY(glm::distance(pose.axis, directionOf(motion.to[Axis::a], motion.to[Axis::c])) < 5e-6);
            QVERIFY2(std::abs(found[next].feed - motion.feed) < 0.06, qPrintable(QString::number(found[next].feed)));
            ++next;
        }
    }

    /// LinuxCNC's interpreter reads the contact points of the program that was opened in the one that is posted: the
    /// ball's centre at the end of each cut, and its direction, by matrices.
    void itsContactsStayWhereTheyWere() {
        if (!CanonicalProgram::available()) QSKIP("rs274 (package linuxcnc-uspace) is not installed");
        const MillingContext milling = tiltingMilling();
        const auto path = pathOf(passesOf(job, milling), milling);
        const auto program = posted(milling, *path);
        QVERIFY(program);
        const std::vector<ToolPose> wanted = centres(CanonicalProgram::ofText(job)),
                                    found = centres(CanonicalProgram::ofText(program->text));
        QCOMPARE(wanted.size(), std::size_t{7});
        std::size_t next = 0;
        for (const ToolPose& pose : wanted) {
            const auto same = [&](const ToolPose& other) {
                return glm::distance(other.tip, pose.tip) < 0.0015 && glm::distance(other.axis, pose.axis) < 5e-6;
            };
            while (next < found.size() && !same(found[next])) ++next;
            QVERIFY2(next < found.size(), program->text.c_str());
            ++next;
        }
    }

    /// A block that begins and ends clear of the part, with C turning the tilted tool into a wall in between. By dense
    /// poses and dense points of the part, a capsule is as deep in it as the check says, and where it says.
    void aGougeBetweenTwoClearPosesIsFound() {
        const MillingContext milling = tiltingMilling();
        const auto check = [&](const std::string& cut) {
            Progress progress;
            ProgramRequest request;
            request.dialect = "linuxcnc";
            return checkProgram(milling,
                                "G21 G90 G17 G94 G54\nT4 M6\nG43 H4\nM3 S10000\nG0 A0 C0 X-4 Y-7.4\nZ20\nA20 C-90\n"
                                "G0 Z2\nG1 Z-7 F300\n" +
                                    cut + "\nZ2\nG0 Z20\nM5\nM2\n",
                                "a.ngc", request, progress);
        };
        const auto kept = check("X4 F600");
        QVERIFY2(kept, kept ? "" : (kept.error().subject + kept.error().place).c_str());
        QVERIFY(kept->report.gougeMax <= 0.0);
        const auto turned = check("X4 C90 F600");
        QVERIFY(turned);
        double deepest = 0.0;
        glm::dvec3 where(0.0);
        for (int i = 0; i <= 800; ++i) {
            const double share = i / 800.0;
            const glm::dvec3 tip(6.0 + 8.0 * share, 2.6, 3.0), axis = directionOf(20.0, -90.0 + 180.0 * share);
            for (const glm::dvec3& point : cornerOfThePart()) {
                const double along = std::clamp(glm::dot(point - tip, axis), 2.0, 25.0);
                const double depth = 2.0 - glm::distance(point, tip + along * axis);
                if (depth <= deepest) continue;
                deepest = depth;
                where = point;
            }
        }
        QVERIFY2(deepest > 0.3, qPrintable(QString::number(deepest)));
        QVERIFY2(std::abs(turned->report.gougeMax - deepest) < 0.002,
                 qPrintable(QString("%1, by brute force %2").arg(turned->report.gougeMax).arg(deepest)));
        const auto found = std::ranges::find(turned->report.findings, FindingKind::gouge, &Finding::kind);
        QVERIFY(found != turned->report.findings.end());
        QCOMPARE(found->line, std::uint32_t{10});
        QVERIFY2(glm::distance(found->place, where) < 0.2,
                 qPrintable(QString("%1 %2 %3").arg(found->place.x).arg(found->place.y).arg(found->place.z)));
    }

    /// The same axes as vectors of cutter locations give the same path.
    void cutterLocationsTiltTheTool() {
        const MillingContext milling = tiltingMilling();
        const glm::dvec3 axis = directionOf(20.0, 30.0);
        const auto goTo = [](const glm::dvec3& p, const glm::dvec3& a) {
            return QString("GOTO/ %1,%2,%3,%4,%5,%6\n")
                .arg(p.x)
                .arg(p.y)
                .arg(p.z)
                .arg(a.x, 0, 'f', 9)
                .arg(a.y, 0, 'f', 9)
                .arg(a.z, 0, 'f', 9);
        };
        const QString text = "PARTNO T\nUNITS/MM\nLOADTL/4\nSPINDL/10000,RPM,CLW\nMULTAX/ON\nRAPID\n" +
                             goTo({-8, 0, 20}, axis) + "RAPID\n" + goTo({-8, 0, 2}, axis) + "FEDRAT/600,MMPM\n" +
                             goTo({-8, 0, -1}, axis) + goTo({0, 0, -1}, axis) + goTo({4, 0, -1}, {0, 0, 1}) + "FINI\n";
        const ProgramPasses passes = passesOf(text.toStdString(), milling);
        QVERIFY(passes.passes.front().tilted);
        const auto& stroke = passes.passes.front().moves.strokes.front();
        QCOMPARE(stroke.size(), std::size_t{4});
        QVERIFY(glm::distance(stroke[2].pose.axis, axis) < 1e-8 &&
                glm::distance(stroke[2].pose.tip, milling.setup.workOffset + glm::dvec3(0, 0, -1)) < 1e-9);
        QVERIFY(glm::distance(stroke[3].pose.axis, {0, 0, 1}) < 1e-8);
        QVERIFY(pathOf(passes, milling));
        const auto upright = parseCutterLocations(text.toStdString(), "a.cls");
        QVERIFY(!upright && upright.error().detail == "a tool axis other than +Z");
    }

    /// On a machine of three axes rotary words are none; with them a tool that is no ball is refused with its line.
    void whatCannotBeTiltedIsRefused() {
        const MillingContext milling = tiltingMilling();
        Progress progress;
        Tool flat = sessionTool();
        flat.cutter.type = CutterType::flat;
        flat.cutter.cornerRadius = 0.0;
        const auto notBall = passesOfProgram(job, "a.ngc", "linuxcnc", milling, ToolChoice{{flat}, true}, progress);
        QCOMPARE(notBall.error().code, ErrorCode::programSyntax);
        QCOMPARE(notBall.error().place, std::string("line 8"));
        const MillingContext upright = blockMilling();
        const auto three =
            passesOfProgram(job, "a.ngc", "linuxcnc", upright, ToolChoice{{sessionTool()}, true}, progress);
        QCOMPARE(three.error().code, ErrorCode::programSyntax);
        QVERIFY(three.error().place.starts_with("line 4"));
    }

    /// An axis beyond its limits is found in a program's text, at its line.
    void rotaryLimitsAreChecked() {
        const MillingContext milling = tiltingMilling();
        ProgramRequest request;
        request.dialect = "linuxcnc";
        Progress progress;
        const auto checked = checkProgram(
            milling, "G21 G90 G94 G54\nT4 M6\nG43 H4\nM3 S10000\nG0 X0 Y0 Z30 A0 C0\nA120\nA0\nG1 Z20 F100\nM5\nM2\n",
            "a.ngc", request, progress);
        QVERIFY2(checked, checked ? "" : (checked.error().subject + checked.error().place).c_str());
        const auto found = std::ranges::find(checked->report.findings, FindingKind::rotaryLimit, &Finding::kind);
        QVERIFY(found != checked->report.findings.end());
        QCOMPARE(found->line, std::uint32_t{6});
        QCOMPARE(found->amount, 120.0);
    }
};

BURIN_TEST(TestTiltedProgram, NoApplication)

} // namespace burin::tst_tilted_program

#include "tst_tilted_program.moc"
