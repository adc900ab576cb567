// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"
#include "core/base/numbers.h"
#include "core/nc/parser.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QCoreApplication>
#include <QTest>

#include <cmath>

namespace burin::tst_parser {

namespace {

Result<ParsedProgram> parseFixture(const char* name) {
    const auto text = readFile(std::filesystem::path(BURIN_FIXTURES) / "gcode" / name);
    return text ? parseProgram(*text, name) : Result<ParsedProgram>(text.error());
}

} // namespace

class TestParser : public QObject {
    Q_OBJECT

private slots:
    void movesGoWhereTheTextSays() {
        const auto program = parseProgram("%\n(job)\nN10 G21 G90 T3\nM6 S9000 M3\nG0 X1 Y-2\nz5.5\n"
                                          "g1 x +1.5 F 200 ; down\n\nG91 X.25 Z-0.5 M8\nG90 G20 X1 M9\nM5\nM2\n%\n",
                                          "job");
        QVERIFY(program);
        QCOMPARE(program->blocks, std::size_t{9});
        QVERIFY(program->ended);
        QCOMPARE(program->maximumSpindleSpeed, 9000.0);
        const std::vector<NcMotion>& m = program->motions;
        QCOMPARE(m.size(), std::size_t{5});
        QVERIFY(m[0].rapid() && m[0].fromKnown.empty());
        QVERIFY(m[1].rapid() && m[1].fromKnown == AxisSet(Axis::x, Axis::y));
        QVERIFY(m[1].to == AxisValues(1, -2, 5.5));
        QVERIFY(!m[2].rapid() && m[2].fromKnown.has(Axis::z));
        QVERIFY(m[2].from == m[1].to && m[2].to == AxisValues(1.5, -2, 5.5));
        QCOMPARE(m[2].feed, 200.0);
        QVERIFY(m[3].to == AxisValues(1.75, -2, 5.0));
        QVERIFY(m[4].to == AxisValues(25.4, -2, 5.0));
        for (const NcMotion& motion : m) QVERIFY(motion.spindleOn() && motion.tool == 3);
        QCOMPARE(m[2].line, 7u);
        QCOMPARE(m[4].line, 10u);
    }

    void whatATextDoesNotTellIsUnknown_data() {
        QTest::addColumn<QString>("between");
        QTest::addColumn<QString>("known");
        QTest::newRow("nothing between") << ""
                                         << "xyz";
        QTest::newRow("tool change") << "T2 M6"
                                     << "";
        QTest::newRow("length offset") << "G43 H2"
                                       << "xy";
        QTest::newRow("no length offset") << "G49"
                                          << "xy";
        QTest::newRow("another work offset") << "G55"
                                             << "";
        QTest::newRow("the same work offset") << "G54"
                                              << "xyz";
    }
    void whatATextDoesNotTellIsUnknown() {
        QFETCH(QString, between);
        QFETCH(QString, known);
        const auto program = parseProgram(("G0 X1 Y1 Z1\n" + between + "\nG0 X2 Y2 Z2\n").toStdString(), "job");
        QVERIFY(program);
        QString found;
        for (int axis = 0; axis < 3; ++axis) {
            if (program->motions[1].fromKnown.has(linearAxis(axis))) found += QChar('x' + axis);
        }
        QCOMPARE(found, known);
    }

    void arcsStayOnTheirCircle_data() {
        QTest::addColumn<QString>("start");
        QTest::addColumn<QString>("arc");
        QTest::addColumn<int>("u");
        QTest::addColumn<int>("v");
        QTest::addColumn<double>("turn"); // rad, positive from u to v
        const double q = std::acos(0.0);
        QTest::newRow("XY quarter, clockwise") << "X0 Y10 Z0"
                                               << "G17 G2 X10 Y0 I0 J-10" << 0 << 1 << -q;
        QTest::newRow("XY three quarters") << "X0 Y10 Z0"
                                           << "G17 G3 X10 Y0 J-10" << 0 << 1 << 3 * q;
        QTest::newRow("XY full turn, end left out") << "X0 Y10 Z0"
                                                    << "G2 J-10" << 0 << 1 << -4 * q;
        QTest::newRow("XY full turn, end given") << "X0 Y10 Z0"
                                                 << "G3 X0 Y10 J-10" << 0 << 1 << 4 * q;
        QTest::newRow("helix") << "X0 Y10 Z0"
                               << "G3 X0 Y10 Z-5 J-10" << 0 << 1 << 4 * q;
        QTest::newRow("ZX quarter, clockwise") << "X0 Y0 Z10"
                                               << "G18 G2 X-10 Z0 K-10" << 2 << 0 << -q;
        QTest::newRow("ZX quarter") << "X0 Y0 Z10"
                                    << "G18 G3 X10 Z0 K-10" << 2 << 0 << q;
        QTest::newRow("YZ quarter, clockwise") << "X0 Y0 Z10"
                                               << "G19 G2 Y10 Z0 K-10" << 1 << 2 << -q;
    }
    void arcsStayOnTheirCircle() {
        QFETCH(QString, start);
        QFETCH(QString, arc);
        QFETCH(int, u);
        QFETCH(int, v);
        QFETCH(double, turn);
        const auto program = parseProgram(("G0 " + start + "\nF100 " + arc).toStdString(), "job");
        QVERIFY(program);
        double turned = 0.0;
        const std::vector<NcMotion> moves = straightMoves(*program, 0.001);
        for (std::size_t i = 1; i < moves.size(); ++i) {
            const NcMotion& m = moves[i];
            QVERIFY(!m.rapid() && m.line == 2);
            const glm::dvec3 from = m.from.linear(), to = m.to.linear();
            QVERIFY(std::abs(std::hypot(to[u], to[v]) - 10.0) < 1e-9);
            const glm::dvec3 middle = 0.5 * (from + to);
            QVERIFY(10.0 - std::hypot(middle[u], middle[v]) <= 0.001 + 1e-12); // the stated chord
            turned += std::atan2(from[u] * to[v] - from[v] * to[u], from[u] * to[u] + from[v] * to[v]);
        }
        QVERIFY(std::abs(turned - turn) < 1e-9);
    }

    void strangersProgramsAreReadOrRefused_data() {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<qulonglong>("motions"); // 0: refused
        QTest::addColumn<QString>("place");
        // Counts from gcode-toolpath, another parser; plugins.linuxcnc compares the moves themselves with rs274.
        QTest::newRow("tball") << QByteArray("tball.gcode") << 2681ull << "";
        QTest::newRow("tball-engrave") << QByteArray("tball-engrave.gcode") << 3430ull << "";
        QTest::newRow("jsdc") << QByteArray("jsdc.gcode") << 2382ull << "";
        QTest::newRow("wrong radius") << QByteArray("circle-diamond-square.gcode") << 0ull << "line 624, column 9";
        QTest::newRow("modal arc without offsets")
            << QByteArray("full-circle-without-xyz.gcode") << 0ull << "line 11, column 5";
        QTest::newRow("incremental from nowhere")
            << QByteArray("helical-thread-milling.gcode") << 0ull << "line 4, column 5";
        QTest::newRow("temporary offsets") << QByteArray("g92offset.nc") << 0ull << "line 28, column 1";
        QTest::newRow("checksums") << QByteArray("special-fields.gcode") << 0ull << "line 3, column 6";
        QTest::newRow("expressions") << QByteArray("nist-expressions.ngc") << 46ull << "";
        QTest::newRow("cycles") << QByteArray("nist-cycles.ngc") << 0ull << "line 3, column 11";
    }
    void strangersProgramsAreReadOrRefused() {
        QFETCH(QByteArray, file);
        QFETCH(qulonglong, motions);
        QFETCH(QString, place);
        const auto program = parseFixture(file.constData());
        if (motions == 0) {
            QVERIFY(!program);
            QCOMPARE(program.error().code, ErrorCode::programSyntax);
            QCOMPARE(QByteArray::fromStdString(program.error().subject), file);
            QCOMPARE(QString::fromStdString(program.error().place), place);
        } else {
            QVERIFY2(program, program ? "" : program.error().place.c_str());
            QCOMPARE(program->motions.size(), std::size_t{motions});
        }
    }

    void theInchCircleIsHalfAnInch() {
        const auto program = parseFixture("circle-inch.gcode");
        QVERIFY(program);
        std::size_t onCircle = 0;
        for (const NcMotion& m : straightMoves(*program, 0.001)) {
            if (m.feed != 2.5 * 25.4) continue;
            QVERIFY(std::abs(std::hypot(m.to[Axis::x], m.to[Axis::y]) - 12.7) < 1e-9);
            ++onCircle;
        }
        QVERIFY(onCircle > 4 * 20);
        QVERIFY(program->motions.back().to == AxisValues(0, 0, 0.25 * 25.4));
    }

    void theZxArcEndsWhereItSays() {
        const auto program = parseFixture("arc-zx-plane.nc");
        QVERIFY(program);
        QVERIFY(glm::distance(program->motions.back().to.linear(), glm::dvec3(20, 0, 0)) < 1e-9);
        QVERIFY(!program->motions.back().fromKnown.has(Axis::y)); // no block ever set Y
    }

    void feedsAreResolved() {
        const auto program = parseProgram("G0 X0 Y0 Z0 S2000 M3\nG93 G1 X10 F2\nG2 X10 Y0 I-10 F1\nG95 G1 X0 F0.1\n"
                                          "G94 X5 F300\nG20 X1\n",
                                          "job");
        QVERIFY(program);
        const auto& m = program->motions;
        QCOMPARE(m[1].feed, 20.0); // 10 mm in half a minute
        QVERIFY(std::abs(m[2].feed - 20.0 * std::acos(-1.0)) < 1e-9);
        QCOMPARE(m[3].feed, 200.0);
        QCOMPARE(m[4].feed, 300.0);
        QCOMPARE(m[5].feed, 300.0); // the feed in force stays, whatever the unit
        QVERIFY(m[1].feedMode == FeedMode::inverseTime && m[3].feedMode == FeedMode::perRevolution);
    }

    void whatIsInForceStandsWithEachMove() {
        const auto program = parseProgram("T4 M6\nG43 H7 G55 S500 M4 M8\nG0 X1 Y1 Z1\nM5 M9\nG49 G54.1\n", "job");
        QVERIFY(!program);
        const auto fine = parseProgram("T4 M6\nG43 H7 G55 S500 M4 M8\nG0 X1 Y1 Z1\nM5 M9\nX2\n", "job");
        QVERIFY(fine);
        const NcMotion &a = fine->motions[0], &b = fine->motions[1];
        QVERIFY(a.tool == 4 && a.lengthOffset == 7 && a.workOffset == 55 && a.flood && !a.mist);
        QVERIFY(a.spindle == SpindleState::anticlockwise && a.spindleSpeed == 500.0 && a.spindleOn());
        QVERIFY(!b.spindleOn() && !b.flood && b.line == 5 && b.column == 1);
    }

    void turnsAreKeptAndFlattened() {
        const auto program = parseProgram("G0 X10 Y0 Z0\nG2 X-10 Y0 Z-6 I-10 P3 F100\n", "job");
        QVERIFY(program);
        QCOMPARE(program->motions.size(), std::size_t{2});
        const NcMotion& arc = program->motions[1];
        const double pi = std::acos(-1.0);
        QCOMPARE(arc.wholeTurns, 2u);
        QVERIFY(std::abs(arc.turn().sweep + 5.0 * pi) < 1e-9);
        QVERIFY(std::abs(lengthOf(arc) - std::hypot(50.0 * pi, 6.0)) < 1e-9);
        const auto moves = straightMoves(*program, 0.001);
        QVERIFY(moves.back().to == arc.to);
        for (std::size_t i = 1; i < moves.size(); ++i) {
            QVERIFY(std::abs(std::hypot(moves[i].to[Axis::x], moves[i].to[Axis::y]) - 10.0) < 1e-9);
            QVERIFY(moves[i].to[Axis::z] < moves[i].from[Axis::z]); // descends evenly through all turns
            const glm::dvec3 middle = 0.5 * (moves[i].from.linear() + moves[i].to.linear());
            QVERIFY(10.0 - std::hypot(middle.x, middle.y) <= 0.001 + 1e-12);
        }
    }

    void zerosOfItsOwnAreSaid() {
        QVERIFY(!parseProgram("G0 X1\nG92 X0\nG0 X2\n", "job")->motions[1].ownZero); // a shift from a known position
        const auto nowhere = parseProgram("G92 X0\nG0 X2\n", "job");
        QVERIFY(nowhere->motions[0].ownZero);
        QVERIFY(parseProgram("G10 L2 P1 X5\nG0 X2\n", "job")->motions[0].ownZero);
        QCOMPARE(parseProgram("G0 X1\nG92 X0\nG0 X2\n", "job")->motions[1].to[Axis::x], 3.0);
    }

    void nothingIsIgnored_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("place");
        QTest::newRow("unknown G") << "G0 X1\nG5 X2"
                                   << "line 2, column 1";
        QTest::newRow("a G number between two") << "G1.05 X1"
                                                << "line 1, column 1";
        QTest::newRow("unknown letter") << "G0 A1"
                                        << "line 1, column 4";
        QTest::newRow("letter without number") << "G0 X Y1"
                                               << "line 1, column 4";
        QTest::newRow("two points in a number") << "G0 X1.2.3"
                                                << "line 1, column 8";
        QTest::newRow("two signs") << "G0 X--1"
                                   << "line 1, column 4";
        QTest::newRow("exponent") << "G0 X1e3"
                                  << "line 1, column 6";
        QTest::newRow("beyond any machine") << "G0 X123456789"
                                            << "line 1, column 4";
        QTest::newRow("comment not closed") << "G0 X1 (down"
                                            << "line 1, column 7";
        QTest::newRow("comment in a comment") << "(a (b))"
                                              << "line 1, column 4";
        QTest::newRow("word twice") << "G0 X1 X2"
                                    << "line 1, column 7";
        QTest::newRow("two motions") << "G0 G1 X1 F1"
                                     << "line 1, column 4";
        QTest::newRow("two units") << "G20 G21"
                                   << "line 1, column 5";
        QTest::newRow("N not first") << "G0 N5 X1"
                                     << "line 1, column 4";
        QTest::newRow("percent beside words") << "% G0"
                                              << "line 1, column 3";
        QTest::newRow("axis without motion") << "X1"
                                             << "line 1, column 1";
        QTest::newRow("axis after G80") << "G0 X1\nG80 X2"
                                        << "line 2, column 5";
        QTest::newRow("feed missing") << "G1 X1"
                                      << "line 1, column 4";
        QTest::newRow("negative feed") << "G1 X1 F-1"
                                       << "line 1, column 7";
        QTest::newRow("feed beside other units") << "G21 G1 X1 F100\nG20 X2 F5"
                                                 << "line 2, column 8";
        QTest::newRow("dwell without time") << "G4"
                                            << "line 1, column 1";
        QTest::newRow("dwell that moves") << "G4 P1 X1"
                                          << "line 1, column 1";
        QTest::newRow("P alone") << "G0 X1 P1"
                                 << "line 1, column 7";
        QTest::newRow("H alone") << "H1"
                                 << "line 1, column 1";
        QTest::newRow("half a tool") << "T1.5"
                                     << "line 1, column 1";
        QTest::newRow("offset without arc") << "G0 X1 I1"
                                            << "line 1, column 7";
        QTest::newRow("offset across the plane") << "G0 X0 Y0\nG2 X1 K1 F1"
                                                 << "line 2, column 7";
        QTest::newRow("arc of radius zero") << "G0 X0 Y0\nG2 X1 Y0 I0 F1"
                                            << "line 2, column 4";
        QTest::newRow("arc from nowhere") << "G2 X1 Y0 I1 F1"
                                          << "line 1, column 4";
        QTest::newRow("control character") << QString("G0 X1 ") + QChar(1) << "line 1, column 7";
    }
    void nothingIsIgnored() {
        QFETCH(QString, text);
        QFETCH(QString, place);
        const auto program = parseProgram(text.toStdString(), "job");
        QVERIFY(!program);
        QCOMPARE(program.error().code, ErrorCode::programSyntax);
        QCOMPARE(QString::fromStdString(program.error().place), place);
    }

    void numbersAreReadToTheLastBit() {
        QVERIFY(rc::check("the nearest double of any decimal number", [] {
            const int decimals = *rc::gen::inRange(0, 12);
            const double value = static_cast<double>(*rc::gen::inRange<std::int64_t>(-9999999999, 9999999999)) / 1003.0;
            const std::string text = formatFixed(value, decimals);
            const auto program = parseProgram("G0 X" + text, "job");
            RC_ASSERT(static_cast<bool>(program));
            RC_ASSERT(program->motions.front().to[Axis::x] == *parseNumber(text));
        }));
    }

    void noTextBringsItDown() {
        QVERIFY(rc::check("any text is read or refused", [](const std::string& text) {
            const auto program = parseProgram(text, "job");
            const bool judged = program || program.error().code == ErrorCode::programSyntax;
            RC_ASSERT(judged);
        }));
        QVERIFY(rc::check("any mixture of words is read or refused", [] {
            const auto words = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
                "G0 ", "G1 ", "G2 ", "G3 ", "G91 ", "G90 ", "G18 ", "G20 ", "X1", "Y-2.5", "Z.5", "I1", "K-1", "F9",
                "\n", "M6", "T1", "(c)", "%", "/", "M2\n", "G43", "H1"));
            std::string text;
            for (const std::string& word : words) text += word;
            const auto program = parseProgram(text, "job");
            if (!program) return;
            for (const NcMotion& m : program->motions)
                RC_ASSERT(std::isfinite(m.to[Axis::x] + m.to[Axis::y] + m.to[Axis::z]));
        }));
    }
};

BURIN_TEST(TestParser, QCoreApplication)

} // namespace burin::tst_parser

#include "tst_parser.moc"
