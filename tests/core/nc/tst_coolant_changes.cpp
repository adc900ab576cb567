// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"
#include "core/nc/data_post.h"
#include "core/nc/lint.h"
#include "core/nc/parser.h"
#include "tests/core/nc/dialect_jobs.h"
#include "tests/oracles/canonical_program.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace burin::tst_coolant_changes {

namespace {

/// Flood, then off, mist and flood again from line to line.
NcProgram misty() {
    NcProgram job = referenceJob(NcUnits::millimetre, 1);
    NcSection& section = job.sections.front();
    section.moves = {rapidTo(0, 0, 10),      lineTo(0, 0, -1, 300),  lineTo(10, 0, -1, 900), lineTo(20, 0, -1, 500),
                     lineTo(30, 0, -1, 500), lineTo(40, 0, -1, 500), rapidTo(40, 0, 10)};
    section.moves[3].coolant = Coolant::off;
    section.moves[4].coolant = Coolant::mist;
    section.moves[5].coolant = Coolant::flood;
    return job;
}

} // namespace

/// Changes of the coolant while a tool cuts, in every dialect that is data.
class TestCoolantChanges : public QObject {
    Q_OBJECT
private slots:
    void coolantChangesInTheCut_data() {
        QTest::addColumn<QString>("dialect");
        QTest::addColumn<bool>("hasMist");
        for (const char* id : {"fanuc", "grblhal", "linuxcnc", "mach"}) QTest::newRow(id) << id << true;
        for (const char* id : {"grbl", "haas"}) QTest::newRow(id) << id << false;
    }
    /// The dialect's control reads the intended coolant of each move; nothing else changes, and there is no dwell for
    /// it.
    void coolantChangesInTheCut() {
        QFETCH(QString, dialect);
        QFETCH(bool, hasMist);
        NcProgram job = misty();
        QCOMPARE(posted(dialect.toStdString(), job).hasValue(), hasMist);
        if (!hasMist) job.sections.front().moves[4].coolant = Coolant::flood;
        NcProgram plain = job;
        for (NcMove& move : plain.sections.front().moves) move.coolant.reset();
        const auto text = posted(dialect.toStdString(), job), without = posted(dialect.toStdString(), plain);
        QVERIFY(text && without);
        const Control* control = findControl(dialect.toStdString());
        const auto program = parseProgram(*text, "job", *control), other = parseProgram(*without, "job", *control);
        QVERIFY2(program, program ? "" : (program.error().place + ": " + program.error().detail).c_str());
        QVERIFY(other);
        QCOMPARE(program->motions.size(), other->motions.size());
        std::string coolants;
        for (const NcMotion& motion : program->motions)
            if (motion.kind == NcMotionKind::line) coolants += motion.flood ? 'F' : motion.mist ? 'M' : '-';
        QCOMPARE(coolants, std::string(hasMist ? "FF-MF" : "FF-FF"));
        const MachineProfile machine = roomyMachine();
        for (const LintMark& mark : lint(*text, {control, &machine}))
            QFAIL((std::to_string(mark.line) + ": " + mark.text).c_str());
    }

    /// The blocks of a change, and the speed and coolant of each move that LinuxCNC's interpreter reads from them.
    void speedAndCoolantReadAsAMachinistExpects() {
        NcProgram job = misty();
        job.sections.front().moves[4].spindleSpeed = 6000;
        const auto text = posted("linuxcnc", job);
        QVERIFY(text);
        QVERIFY2(text->find("X10.000 F900\nM9\nX20.000 F500\nS6000 M3\nM7\nX30.000\nM9\nM8\nX40.000\n") !=
                     std::string::npos,
                 text->c_str());
        const auto fanuc = posted("fanuc", job);
        QVERIFY(fanuc);
        QVERIFY2(fanuc->find("\nM09\nX20. F500.\nS6000 M03\nM07\nX30.\nM09\nM08\nX40.\n") != std::string::npos,
                 fanuc->c_str());
        if (!CanonicalProgram::available()) QSKIP("rs274 (package linuxcnc-uspace) is not installed");
        const CanonicalProgram truth = CanonicalProgram::ofText(*text);
        QVERIFY2(truth.exitCode == 0, qPrintable(truth.complaint));
        std::vector<std::string> lines;
        for (const CanonicalMove& move : truth.moves)
            if (move.kind == CanonicalKind::line)
                lines.push_back(std::to_string(std::lround(move.spindleSpeed)) + (move.flood ? "F" : "") +
                                (move.mist ? "M" : ""));
        QVERIFY((lines == std::vector<std::string>{"12000F", "12000F", "12000", "6000M", "6000F"}));
    }

    /// A dialect whose tool change has the coolant before the spindle changes them in that order, with its own words
    /// and blocks.
    void theOrderIsThatOfTheToolChange() {
        const auto data = readFile(std::string(BURIN_SOURCE_DIRECTORY) + "/resources/dialects/linuxcnc.json");
        QVERIFY(data);
        auto dialect = dialectFromJson(*data, "linuxcnc.json");
        QVERIFY(dialect);
        QCOMPARE(dialect->coolantOff, std::string("M9"));
        std::ranges::reverse(dialect->toolChange);
        dialect->coolantChange = {"{coolant_off} {coolant}"};
        dialect->coolantOff = "M209";
        NcProgram job = misty();
        job.sections.front().moves[4].spindleSpeed = 6000;
        Progress progress;
        const auto text = writeProgram(job, roomyMachine(), DataPost(*dialect), progress);
        QVERIFY(text);
        QVERIFY2(text->find("\nM209\nX20.000 F500\nM7\nS6000 M3\nX30.000\nM209 M8\nX40.000\n") != std::string::npos,
                 text->c_str());
    }
};

BURIN_TEST(TestCoolantChanges, QCoreApplication)

} // namespace burin::tst_coolant_changes

#include "tst_coolant_changes.moc"
