// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"
#include "core/nc/dialect_library.h"
#include "core/nc/parser.h"
#include "core/nc/post.h"
#include "tests/oracles/canonical_program.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QCoreApplication>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <random>

namespace burin::tst_linuxcnc {

namespace {

MachineProfile machine() {
    MachineProfile profile;
    profile.toolChangeHeight = 60;
    profile.coordinateDecimals = 3;
    profile.maximumLineLength = 255;
    return profile;
}

NcMove rapid(double x, double y, double z) {
    return {NcMoveKind::rapid, {x, y, z}, 0.0, 0, -1, ""};
}
NcMove line(double x, double y, double z, double feed, std::string comment = {}) {
    return {NcMoveKind::line, {x, y, z}, feed, 1, 1, std::move(comment)};
}

NcProgram referenceJob() {
    NcProgram program;
    program.name = "Mouse (finish)";
    program.header = {"Part: Maus für links", "MSG, not an order"};
    program.safeHeight = 10;
    program.blendTolerance = 0.005;
    NcSection& section = program.sections.emplace_back();
    section.toolNumber = 3;
    section.toolName = "Ball-end mill 6 mm";
    section.spindleSpeed = 12000;
    section.moves = {rapid(-5.0004, 12.3456, 10),
                     rapid(-5.0004, 12.3456, 1),
                     line(-5.0004, 12.3456, -0.0004, 300, "take 1, sample 17"), // rounds to 0.000, not -0.000
                     line(-4, 12.3456, -0.0004, 1234.56),
                     line(-4.0004, 12.3459, 0.0003, 1234.56), // nothing of it remains after rounding
                     line(-3, 13, 0.5, 1234.56),
                     rapid(-3, 13, 10)};
    return program;
}

const char* const referenceText = R"((Mouse [finish])
(Part: Maus f?r links)
(MSG: not an order)
G17 G21 G40 G49
G54 G80 G90 G91.1 G94
G64 P0.005 Q0.005
(Ball-end mill 6 mm)
T3 M6
G43 H3
S12000 M3
G4 P3
G0 Z60.000
X-5.000 Y12.346
Z10.000
Z1.000
(take 1, sample 17)
G1 Z0.000 F300
X-4.000 F1234.6
X-3.000 Y13.000 Z0.500
G0 Z10.000
Z60.000
M5
M9
M2
)";

Result<std::string> posted(const NcProgram& program, const MachineProfile& profile = machine()) {
    auto post = loadDialect("linuxcnc");
    if (!post) return post.error();
    Progress progress;
    return writeProgram(program, profile, **post, progress);
}

/// rs274 starts at the origin, for which the parser uses 0 where the position is unknown.
void compare(const CanonicalProgram& truth, const ParsedProgram& parsed) {
    std::vector<CanonicalMove> moves = truth.moves;
    std::vector<NcMotion> motions = parsed.motions;
    std::erase_if(moves, [](const CanonicalMove& move) { return move.kind == CanonicalKind::dwell; });
    std::erase_if(motions, [](const NcMotion& motion) { return motion.kind == NcMotionKind::dwell; });
    QCOMPARE(moves.size(), motions.size());
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const glm::dvec3 difference = glm::abs(moves[i].to * moves[i].unit - motions[i].to.linear());
        const double doubt = moves[i].doubt * moves[i].unit;
        QVERIFY2((moves[i].kind == CanonicalKind::rapid) == motions[i].rapid(), qPrintable(QString("move %1").arg(i)));
        QVERIFY2(difference.x <= doubt && difference.y <= doubt && difference.z <= doubt,
                 qPrintable(QString("move %1").arg(i)));
    }
}

NcProgram randomProgram() {
    NcProgram program = referenceJob();
    program.sections.front().moves.clear();
    const auto coordinate = [] { return *rc::gen::inRange(-200000, 200000) / 1700.0; };
    program.sections.front().moves.push_back(rapid(coordinate(), coordinate(), 10));
    const int count = *rc::gen::inRange(0, 60);
    for (int i = 0; i < count; ++i) {
        if (*rc::gen::inRange(0, 5) == 0)
            program.sections.front().moves.push_back(rapid(coordinate(), coordinate(), coordinate()));
        else
            program.sections.front().moves.push_back(
                line(coordinate(), coordinate(), coordinate(), *rc::gen::inRange(1, 90000) / 10.0));
    }
    return program;
}

} // namespace

class TestLinuxCnc : public QObject {
    Q_OBJECT

private slots:
    void aJobReadsAsAMachinistExpects() {
        const auto text = posted(referenceJob());
        QVERIFY2(text, text ? "" : text.error().detail.c_str());
        QCOMPARE(QString::fromStdString(*text), QString(referenceText));
    }

    void theProgramMeansWhatWasPosted() {
        QVERIFY(rc::check("every move comes back, rounded to its last digit, at its feed", [] {
            const NcProgram program = randomProgram();
            const auto text = posted(program);
            RC_ASSERT(static_cast<bool>(text));
            const auto parsed = parseProgram(*text, "job");
            RC_ASSERT(static_cast<bool>(parsed));
            RC_ASSERT(parsed->ended && parsed->maximumSpindleSpeed == 12000.0);
            std::size_t at = 3; // after the spindle start and the moves up and across
            for (const NcMove& move : program.sections.front().moves) {
                const glm::dvec3 rounded = glm::round(move.target.linear() * 1000.0) / 1000.0;
                if (glm::distance(parsed->motions[at - 1].to.linear(), rounded) < 1e-9)
                    continue; // zero length: no block
                RC_ASSERT(glm::distance(parsed->motions[at].to.linear(), rounded) < 1e-9);
                RC_ASSERT(parsed->motions[at].rapid() == (move.kind == NcMoveKind::rapid));
                if (!parsed->motions[at].rapid())
                    RC_ASSERT(std::abs(parsed->motions[at].feed - move.feed) <= 0.05 + 1e-9);
                RC_ASSERT(parsed->motions[at].spindleOn() && parsed->motions[at].tool == 3);
                ++at;
            }
            RC_ASSERT(parsed->motions.back().to[Axis::z] == 60.0);
        }));
    }

    void longCommentsAreContinued() {
        NcProgram program = referenceJob();
        program.header = {std::string(600, 'a')};
        const auto text = posted(program);
        QVERIFY(text);
        const QStringList lines = QString::fromStdString(*text).split('\n');
        qsizetype letters = 0;
        for (const QString& one : lines) {
            QVERIFY(one.size() <= 255);
            if (one.startsWith("(aaa")) letters += one.count('a');
        }
        QCOMPARE(letters, 600);
    }

    void withoutToleranceTheControlStopsExactly() {
        NcProgram program = referenceJob();
        program.blendTolerance = 0;
        const auto text = posted(program);
        QVERIFY(text && text->find("\nG61\n") != std::string::npos && text->find("G64") == std::string::npos);
    }

    void programsThatCannotBeWordedAreRefused() {
        NcProgram withoutFeed = referenceJob();
        withoutFeed.sections.front().moves[3].feed = 0;
        QVERIFY(!posted(withoutFeed));
        NcProgram feedFirst = referenceJob();
        feedFirst.sections.front().moves.erase(feedFirst.sections.front().moves.begin(),
                                               feedFirst.sections.front().moves.begin() + 2);
        QVERIFY(!posted(feedFirst));
        NcProgram nowhere = referenceJob();
        nowhere.sections.front().moves[3].target.set(Axis::x, std::nan(""));
        QVERIFY(!posted(nowhere));
    }

    void linuxCncUnderstandsTheJobAsWeDo() {
        if (!CanonicalProgram::available()) QSKIP("rs274 (package linuxcnc-uspace) is not installed");
        QTemporaryDir folder;
        NcProgram program = referenceJob();
        std::mt19937 random(7);
        std::uniform_real_distribution<double> coordinate(-150, 150);
        for (int i = 0; i < 500; ++i) {
            if (i % 7 == 0)
                program.sections.front().moves.push_back(
                    rapid(coordinate(random), coordinate(random), coordinate(random)));
            else
                program.sections.front().moves.push_back(
                    line(coordinate(random), coordinate(random), coordinate(random), 100 + i));
        }
        const auto text = posted(program);
        QVERIFY(text);
        const QString file = folder.filePath("job.ngc");
        QVERIFY(writeFileAtomically(file.toStdString(), *text));
        const CanonicalProgram truth(file);
        QVERIFY2(truth.exitCode == 0, qPrintable(truth.complaint));
        const auto parsed = parseProgram(*text, "job");
        QVERIFY(parsed);
        compare(truth, *parsed);
    }

    void linuxCncReadsStrangersProgramsAsWeDo_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"tball.gcode", "tball-engrave.gcode", "jsdc.gcode"}) QTest::newRow(name) << name;
    }
    void linuxCncReadsStrangersProgramsAsWeDo() {
        if (!CanonicalProgram::available()) QSKIP("rs274 (package linuxcnc-uspace) is not installed");
        QFETCH(QString, name);
        const QString file = QString(BURIN_FIXTURES "/gcode/") + name;
        const auto text = readFile(file.toStdString());
        QVERIFY(text);
        const auto parsed = parseProgram(*text, name.toStdString());
        QVERIFY(parsed);
        compare(CanonicalProgram(file), *parsed);
    }
};

BURIN_TEST(TestLinuxCnc, QCoreApplication)

} // namespace burin::tst_linuxcnc

#include "tst_linuxcnc.moc"
