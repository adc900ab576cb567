// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/parser.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QTest>

namespace burin::tst_controls {

class TestControls : public QObject {
    Q_OBJECT

private slots:
    /// Facts about single controls: what one accepts and another refuses.
    void eachControlReadsItsOwn_data() {
        QTest::addColumn<QString>("control");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("fault"); // empty: accepted
        const auto row = [](const char* name, const char* control, const char* text, const char* fault = "") {
            QTest::newRow(name) << control << text << fault;
        };
        row("LinuxCNC: % is optional", "linuxcnc", "%\nG0 X1\n%\n");
        row("LinuxCNC: letters of either case", "linuxcnc", "g0x1\nm2\n");
        row("LinuxCNC: active comments", "linuxcnc", "(MSG, ready)(DEBUG,#1)\nG0 X1\nM2\n");
        row("LinuxCNC: turns", "linuxcnc", "G0 X1 Y0\nG2 I-1 P3 F1\n");
        row("LinuxCNC: both absolute offsets", "linuxcnc", "G0 X1 Y0\nG90.1 G2 I0 F1\n", "arc_centre_missing");
        row("LinuxCNC: G59.3", "linuxcnc", "G59.3\n");
        row("LinuxCNC: dynamic length", "linuxcnc", "G43.1 Z5\n");
        row("LinuxCNC: additional length", "linuxcnc", "G43.2 H1\n", "code_not_read");
        row("LinuxCNC: blending", "linuxcnc", "G64 P0.01 Q0.02\nG61.1\n");
        row("LinuxCNC: splines", "linuxcnc", "G0 X0 Y0\nG5 X1 Y1 I1 J1\n", "code_not_read");
        row("LinuxCNC: subroutines", "linuxcnc", "o100 sub\n", "subprogram");
        row("LinuxCNC: near half a circle by R", "linuxcnc", "G0 X0 Y0\nG2 X2 Y0 R0.999 F1\n");
        row("LinuxCNC: radius far too small", "linuxcnc", "G0 X0 Y0\nG2 X2 Y0 R0.9 F1\n", "arc_radius_too_small");
        row("Fanuc: condition", "fanuc", "IF [#1 EQ 1.] GOTO 5\n", "subprogram");
        row("Fanuc: loop", "fanuc", "WHILE [#1 LT 1.] DO1\n", "subprogram");
        row("Fanuc: loop's end", "fanuc", "END1\n", "subprogram");
        row("Fanuc: number in two parts", "fanuc", "G00 X1. 2\n", "character_not_allowed");
        row("GRBL: seconds", "grbl", "G4 P0.5\n");
        row("GRBL: /", "grbl", "/G0 X1\n");
        row("GRBL: expressions", "grbl", "G0 X[1+1]\n", "expression_not_read");
        row("GRBL: parameters", "grbl", "#1=2\n", "expression_not_read");
        row("GRBL: G40 and G80", "grbl", "G40 G49 G80 G61\n");
        row("GRBL: G61.1", "grbl", "G61.1\n", "code_not_read");
        row("GRBL: G59.1", "grbl", "G59.1\n", "code_not_read");
        row("GRBL: G95", "grbl", "G95\n", "code_not_read");
        row("GRBL: D", "grbl", "D1\n", "word_not_read");
        row("GRBL: H", "grbl", "H1\n", "word_not_read");
        row("GRBL: Q", "grbl", "Q1\n", "word_not_read");
        row("GRBL: T", "grbl", "T3\n");
        row("GRBL: G53 with an arc", "grbl", "G0 X1 Y0\nG53 G2 X1 Y0 I1 F1\n", "machine_frame_motion");
        row("grblHAL: cycles", "grblhal", "G0 X0 Y0 Z5\nG81 X1 Y1 Z-1 R1 F1\n");
        row("grblHAL: G64", "grblhal", "G64\n", "code_not_read");
        row("grblHAL: absolute centres", "grblhal", "G90.1\n", "code_not_read");
        row("grblHAL: length table", "grblhal", "T1 M6\nG43 H1\n");
        row("grblHAL: back boring", "grblhal", "G87 X1\n", "code_not_read");
        row("Fanuc: program number", "fanuc", "%\nO0001 (NAME)\nM30\n%\n");
        row("Fanuc: further work offsets", "fanuc", "G54.1 P48\n");
        row("Fanuc: work offset without its number", "fanuc", "G54.1\n", "work_offset_missing");
        row("Fanuc: G59.1", "fanuc", "G59.1\n", "code_not_read");
        row("Fanuc: AI contour control", "fanuc", "G05.1 Q1\n");
        row("Fanuc: macro", "fanuc", "#100=5.\nG00 X#100 Y[#100+1.]\n");
        row("Fanuc: named parameters", "fanuc", "#<a>=5.\n", "expression_not_read");
        row("Fanuc: K repeats", "fanuc", "G00 X0. Y0. Z5.\nG91 G81 X1. Z-1. R1. K3 F1.\n");
        row("Fanuc: home", "fanuc", "G28 G91 Z0.\nG90\n");
        row("Haas: further work offsets", "haas", "G154 P99\nG110\nG129\n");
        row("Haas: smoothing", "haas", "G187 P3 E0.01\nG187\n");
        row("Haas: E alone", "haas", "E0.01\n", "word_without_use");
        row("Haas: home by G53", "haas", "G53 G00 Z0.\n");
        row("Mach: G70", "mach", "G70\nG0 X1\n");
        row("Mach: G50", "mach", "G90 G54 G64 G50 G17 G40 G80 G94 G91.1 G49\n");
        row("Mach: K in XY arcs", "mach", "G0 X0 Y0\nG2 X1 Y0 I0.5 K0 F1\n", "arc_offset_across");
        row("Mach: tolerance of blending", "mach", "G64 P0.01\n", "word_without_use");
    }
    void eachControlReadsItsOwn() {
        QFETCH(QString, control);
        QFETCH(QString, text);
        QFETCH(QString, fault);
        const auto program = parseProgram(text.toStdString(), "job", *findControl(control.toStdString()));
        if (fault.isEmpty()) {
            QVERIFY2(program, program ? "" : (program.error().place + program.error().detail).c_str());
            return;
        }
        QVERIFY(!program);
        std::string wording;
        for (std::size_t i = 0; i < static_cast<std::size_t>(ProgramProblem::count); ++i)
            if (idOf(static_cast<ProgramProblem>(i)) == fault.toStdString())
                wording = wordingOf(static_cast<ProgramProblem>(i));
        QVERIFY(!wording.empty());
        QVERIFY2(program.error().detail.starts_with(wording), program.error().detail.c_str());
    }

    void dwellsCountWhatTheirControlCounts_data() {
        QTest::addColumn<QString>("control");
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("seconds");
        QTest::newRow("LinuxCNC") << "linuxcnc"
                                  << "G4 P1.5" << 1.5;
        QTest::newRow("GRBL") << "grbl"
                              << "G4 P1.5" << 1.5;
        QTest::newRow("grblHAL") << "grblhal"
                                 << "G4 P1.5" << 1.5;
        QTest::newRow("Mach") << "mach"
                              << "G4 P1.5" << 1.5;
        QTest::newRow("Fanuc, P") << "fanuc"
                                  << "G04 P1500" << 1.5;
        QTest::newRow("Fanuc, X") << "fanuc"
                                  << "G04 X1.5" << 1.5;
        QTest::newRow("Haas, whole") << "haas"
                                     << "G04 P1500" << 1.5;
        QTest::newRow("Haas, with a point") << "haas"
                                            << "G04 P1.5" << 1.5;
    }
    void dwellsCountWhatTheirControlCounts() {
        QFETCH(QString, control);
        QFETCH(QString, text);
        QFETCH(double, seconds);
        const auto program = parseProgram(text.toStdString(), "job", *findControl(control.toStdString()));
        QVERIFY(program);
        QCOMPARE(program->motions.size(), std::size_t{1});
        QVERIFY(program->motions[0].kind == NcMotionKind::dwell);
        QCOMPARE(program->motions[0].seconds, seconds);
    }
};

BURIN_TEST(TestControls, QCoreApplication)

} // namespace burin::tst_controls

#include "tst_controls.moc"
