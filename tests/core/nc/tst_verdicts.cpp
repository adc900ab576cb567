// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Constructs of other programs that each control accepts, compared with rs274 and GRBL's published rules.
#include "core/base/file.h"
#include "core/nc/parser.h"
#include "tests/core/nc/beside_rs274.h"
#include "tests/core/nc/texts_of_others.h"
#include "tests/oracles/grbl_rules.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QTest>

#include <map>

namespace burin::tst_verdicts {

using namespace burin::beside_rs274;

namespace {

const char* const table = BURIN_SOURCE_DIRECTORY "/core/nc/verdicts.md";

/// As written for a control that interprets lengths without a decimal point as multiples of its smallest step.
std::string withPoints(const std::string& text) {
    static const QRegularExpression whole("([XYZIJKR]-?\\d+)(?![\\d.])");
    return QString::fromStdString(text).replace(whole, "\\1.").toStdString();
}

Result<ParsedProgram> readFor(const char* control, const std::string& text) {
    const Control& reader = *findControl(control);
    return parseProgram(reader.pointNeeded ? withPoints(text) : text, "job", reader, standing());
}

/// The reference result for the row's program; each is computed once.
const CanonicalProgram& truthOf(const TextOfOthers& one) {
    static std::map<std::string_view, CanonicalProgram> asked;
    const auto known = asked.find(one.name);
    if (known != asked.end()) return known->second;
    return asked.emplace(one.name, CanonicalProgram::ofText(programOf(one))).first->second;
}

/// Removes the second of two consecutive moves that end at the same point, which has no effect.
template <typename Move>
void leaveOutRests(std::vector<Move>& moves, std::size_t known) {
    for (std::size_t i = moves.size(); i-- > known;)
        if (i > 0 && moves[i].to == moves[i - 1].to && static_cast<int>(moves[i].kind) < 2)
            moves.erase(moves.begin() + static_cast<std::ptrdiff_t>(i));
}

std::string cell(const Result<ParsedProgram>& program) {
    if (program) return "yes";
    for (std::size_t i = 0; i < static_cast<std::size_t>(ProgramProblem::count); ++i) {
        const auto problem = static_cast<ProgramProblem>(i);
        if (program.error().detail.starts_with(wordingOf(problem))) return std::string(idOf(problem));
    }
    return program.error().detail;
}

std::string tableOfVerdicts() {
    std::string text = "# What each control takes\n\nOf programs of others (`tests/core/nc/texts_of_others.h`), beside "
                       "LinuxCNC's own interpreter `rs274` and GRBL's published rules; made and judged by "
                       "`tests/core/nc/verdicts`. \"cautious\": Burin refuses what the judge reads.\n\n"
                       "| program | rs274 | linuxcnc | GRBL's rules | grbl";
    for (const char* other : {"grblhal", "fanuc", "haas", "mach"}) text += std::string(" | ") + other;
    text += " |\n|---|---|---|---|---|---|---|---|---|\n";
    for (const TextOfOthers& one : textsOfOthers) {
        const std::string program = programOf(one);
        const GrblVerdict grbl = grblVerdict(program);
        text += "| " + std::string(one.name) + (one.cautious.empty() ? "" : " (cautious)");
        text += truthOf(one).exitCode == 0 ? " | yes" : " | no";
        text += " | " + cell(readFor("linuxcnc", program));
        text += grbl.error == 0 ? " | yes" : " | error " + std::to_string(grbl.error);
        for (const char* other : {"grbl", "grblhal", "fanuc", "haas", "mach"})
            text += " | " + cell(readFor(other, program));
        text += " |\n";
    }
    return text;
}

} // namespace

class TestVerdicts : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        if (!CanonicalProgram::available()) QSKIP("rs274 (package linuxcnc-uspace) is not installed");
    }

    void bothJudgesAgree_data() {
        QTest::addColumn<int>("row");
        for (int i = 0; i < static_cast<int>(std::size(textsOfOthers)); ++i)
            QTest::newRow(std::string(textsOfOthers[i].name).c_str()) << i;
    }
    void bothJudgesAgree() {
        QFETCH(int, row);
        const TextOfOthers& one = textsOfOthers[row];
        const std::string text = programOf(one);
        CanonicalProgram truth = truthOf(one);
        Result<ParsedProgram> program = readFor("linuxcnc", text);
        const auto why = [](const Result<ParsedProgram>& read) {
            return read ? "read" : read.error().place + ": " + read.error().detail;
        };
        const std::string told = why(program) + "; " + truth.complaint.toStdString();
        if (one.cautious.empty())
            QVERIFY2(static_cast<bool>(program) == (truth.exitCode == 0), told.c_str());
        else
            QVERIFY2(!program, "it is not cautious any more");
        if (program) {
            leaveOutRests(truth.moves, 1);
            leaveOutRests(program->motions, 1);
            const QString fault = difference(truth, *program);
            QVERIFY2(fault.isEmpty(), qPrintable(fault));
        }
        const GrblVerdict verdict = grblVerdict(text);
        const Result<ParsedProgram> grbl = readFor("grbl", text);
        const std::string grblTold = why(grbl) + "; error " + std::to_string(verdict.error);
        if (one.cautious.empty())
            QVERIFY2(static_cast<bool>(grbl) == (verdict.error == 0), grblTold.c_str());
        else
            QVERIFY2(!grbl, grblTold.c_str());
    }

    void theTableIsAsItStands() {
        const std::string now = tableOfVerdicts();
        if (qEnvironmentVariableIsSet("BURIN_WRITE_VERDICTS")) QVERIFY(writeFileAtomically(table, now));
        const auto committed = readFile(table);
        QVERIFY2(committed && *committed == now, "core/nc/verdicts.md is out of date: run tests/core/nc/verdicts");
    }

    /// Inputs that used to be read wrongly, with the controls that they apply to.
    void inputsThatFailed_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("controls");
        QTest::addColumn<ProgramProblem>("problem"); // count: accepted
        QTest::addColumn<int>("line");               // of the problem; of the last motion if it is accepted
        const auto row = [](const char* file, const char* which, ProgramProblem problem, int line) {
            QTest::addRow("%s, %s", file, which) << file << which << problem << line;
        };
        const ProgramProblem read = ProgramProblem::count;
        const char *all = "linuxcnc grbl grblhal mach", *shops = "fanuc haas", *rest = "linuxcnc mach fanuc haas";
        row("n02-bom.ngc", all, read, 5);
        row("n07-blanks-inside-numbers.ngc", all, read, 5);
        row("n11-comments-before-percent.ngc", "linuxcnc", ProgramProblem::percentMisplaced, 4);
        row("n15-f-beside-g20.ngc", all, ProgramProblem::unitsChangeBesideFeed, 1);
        row("n15b-g20-and-f-same-line-feed-first.ngc", all, ProgramProblem::unitsChangeBesideFeed, 1);
        row("n40c-crcrlf.ngc", all, read, 4);
        row("n42-words-behind-m2.ngc", "linuxcnc mach", read, 6);
        row("n42-words-behind-m2.ngc", "grbl grblhal", read, 7); // they continue reading
        row("n60-mastercam-safety-line.nc", rest, read, 6);
        row("n60-mastercam-safety-line.nc", "grbl grblhal", ProgramProblem::codesOfOneGroup, 1);
        row("n61-xy-behind-g80.nc", shops, read, 9);
        row("n61-xy-behind-g80.nc", "linuxcnc mach", ProgramProblem::axisWithoutMotion, 8);
        row("n63-subprogram-behind-m30.nc", shops, read, 8);
        row("n66-r-short-05-0.004.ngc", all, ProgramProblem::arcRadiusTooSmall, 5);
    }
    void inputsThatFailed() {
        QFETCH(QString, file);
        QFETCH(QString, controls);
        QFETCH(ProgramProblem, problem);
        QFETCH(int, line);
        const auto text = readFile((QString(BURIN_FIXTURES "/gcode/of-others/") + file).toStdString());
        QVERIFY(text);
        for (const QString& control : controls.split(' ')) {
            const Result<ParsedProgram> program = readFor(qPrintable(control), *text);
            const std::string told =
                control.toStdString() + (program ? "" : program.error().place + program.error().detail);
            QVERIFY2(static_cast<bool>(program) == (problem == ProgramProblem::count), told.c_str());
            if (program) {
                QCOMPARE(program->motions.back().line, static_cast<std::uint32_t>(line));
                continue;
            }
            QVERIFY2(program.error().detail.starts_with(wordingOf(problem)), told.c_str());
            QVERIFY2(program.error().place.starts_with("line " + std::to_string(line) + ","), told.c_str());
        }
    }
};

BURIN_TEST(TestVerdicts, QCoreApplication)

} // namespace burin::tst_verdicts

#include "tst_verdicts.moc"
