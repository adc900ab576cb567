// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"
#include "core/nc/lint.h"
#include "core/nc/parser.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QCoreApplication>
#include <QTest>

namespace burin::tst_lint {

namespace {

MachineProfile machine() {
    MachineProfile made;
    made.maximumFeed = 2000;
    made.minimumSpindleSpeed = 1000;
    made.maximumSpindleSpeed = 24000;
    return made;
}

std::vector<LintMark> marksOf(const QString& text, const char* control) {
    const MachineProfile limits = machine();
    return lint(text.toStdString(), {findControl(control), &limits});
}

QString describe(const LintMark& mark) {
    return QString("%1:%2+%3 %4")
        .arg(mark.line)
        .arg(mark.column)
        .arg(mark.length)
        .arg(QString::fromStdString(std::string(idOf(mark.problem))));
}

} // namespace

class TestLint : public QObject {
    Q_OBJECT

private slots:
    void whatAControlRejectsIsMarked_data() {
        QTest::addColumn<QString>("control");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("mark"); // line:column+length id; empty: no message
        const QString begin = "G21 G54\n";
        QTest::newRow("nothing") << "linuxcnc" << begin + "G0 X1 Y1 Z1\nG1 Z0 F100\nM2\n"
                                 << "";
        QTest::newRow("no end") << "linuxcnc" << begin + "G0 X1\n"
                                << "2:1+2 end_missing";
        QTest::newRow("closing % is an end") << "linuxcnc"
                                             << "%\n" + begin + "G0 X1\n%\n"
                                             << "";
        QTest::newRow("% on GRBL") << "grbl"
                                   << "%\n" + begin + "G0 X1\nM2\n"
                                   << "1:1+1 percent_not_read";
        QTest::newRow("G43 H on GRBL") << "grbl" << begin + "G43 H1\nM2\n"
                                       << "2:1+3 code_not_read";
        QTest::newRow("M6 on GRBL") << "grbl" << begin + "T1 M6\nM2\n"
                                    << "2:4+2 code_not_read";
        QTest::newRow("G64 on GRBL") << "grbl" << begin + "G64 P0.1\nM2\n"
                                     << "2:1+3 code_not_read";
        QTest::newRow("G81 on GRBL") << "grbl" << begin + "G81 X1 Y1 Z1 R2\nM2\n"
                                     << "2:1+3 code_not_read";
        QTest::newRow("G90.1 on GRBL") << "grbl" << begin + "G90.1\nM2\n"
                                       << "2:1+5 code_not_read";
        QTest::newRow("rotary axis on GRBL") << "grbl" << begin + "G0 A1\nM2\n"
                                             << "2:4+2 word_not_read";
        QTest::newRow("79 characters on GRBL")
            << "grbl" << begin + "G0X1" + QString(75, '0').replace(0, 1, ".") + "\nM2\n"
            << "";
        QTest::newRow("80 characters on GRBL")
            << "grbl" << begin + "G0X1" + QString(76, '0').replace(0, 1, ".") + "\nM2\n"
            << "2:80+1 line_too_long";
        QTest::newRow("a comment does not count on GRBL") << "grbl" << begin + "G0 X1 (" + QString(90, 'c') + ")\nM2\n"
                                                          << "";
        QTest::newRow("blanks do not count on GRBL") << "grbl" << begin + "G0" + QString(90, ' ') + "X1\nM2\n"
                                                     << "";
        QTest::newRow("80 characters on a Haas") << "haas"
                                                 << "(" + QString(78, 'C') + ")\n" + begin + "M30\n"
                                                 << "";
        QTest::newRow("81 characters on a Haas") << "haas"
                                                 << "(" + QString(79, 'C') + ")\n" + begin + "M30\n"
                                                 << "1:81+1 line_too_long";
        QTest::newRow("255 characters on LinuxCNC") << "linuxcnc" << begin + ";" + QString(254, 'c') + "\nM2\n"
                                                    << "";
        QTest::newRow("256 characters on LinuxCNC") << "linuxcnc" << begin + ";" + QString(255, 'c') + "\nM2\n"
                                                    << "2:256+1 line_too_long";
        QTest::newRow("comment to the end on a Fanuc") << "fanuc" << begin + "; no\nM30\n"
                                                       << "2:1+1 character_not_allowed";
        QTest::newRow("no decimal point on a Fanuc") << "fanuc" << begin + "G00 X10\nM30\n"
                                                     << "2:5+3 point_missing";
        QTest::newRow("0 needs no decimal point") << "fanuc" << begin + "G00 X0\nM30\n"
                                                  << "";
        QTest::newRow("feed without a decimal point on a Haas")
            << "haas" << begin + "G00 X0. Y0. Z0.\nG01 X1. F100\nM30\n"
            << "3:9+4 feed_point_missing";
        QTest::newRow("G93 without F") << "linuxcnc" << begin + "G0 X0 Y0 Z0\nG93 G1 X1 F2\nX2\nM2\n"
                                       << "4:1+2 feed_missing_inverse_time";
        QTest::newRow("arc of a wrong radius on GRBL") << "grbl" << begin + "G0 X0 Y0\nG2 X10 Y0.006 I5 J0 F100\nM2\n"
                                                       << "";
        QTest::newRow("arc far off on GRBL") << "grbl" << begin + "G0 X0 Y0\nG2 X10.02 Y0 I5 J0 F100\nM2\n"
                                             << "3:4+6 arc_radius_differs";
        QTest::newRow("the same on LinuxCNC") << "linuxcnc" << begin + "G0 X0 Y0\nG2 X10.02 Y0 I5 J0 F100\nM2\n"
                                              << "";
        QTest::newRow("the same on Mach") << "mach" << begin + "G91.1\nG0 X0 Y0\nG2 X10.02 Y0 I5 J0 F100\nM2\n"
                                          << "4:4+6 arc_radius_differs";
        QTest::newRow("full circle without an axis on GRBL") << "grbl" << begin + "G0 X0 Y0\nG2 I5 F100\nM2\n"
                                                             << "3:4+2 axis_missing";
        QTest::newRow("turns on GRBL") << "grbl" << begin + "G0 X0 Y0\nG2 X0 Y0 I5 P2 F100\nM2\n"
                                       << "3:13+2 word_without_use";
        QTest::newRow("arcs on Mach want their mode") << "mach" << begin + "G0 X0 Y0\nG2 X10 Y0 I5 F100\nM2\n"
                                                      << "3:4+3 arc_mode_missing";
        QTest::newRow("cutter compensation") << "linuxcnc" << begin + "G41 D1\nM2\n"
                                             << "2:1+3 cutter_compensation";
        QTest::newRow("subprogram") << "fanuc" << begin + "M98 P1000\nM30\n"
                                    << "2:1+3 subprogram";
        QTest::newRow("no units") << "linuxcnc"
                                  << "G54 G0 X1\nM2\n"
                                  << "1:8+2 units_missing";
        QTest::newRow("no work offset") << "linuxcnc"
                                        << "G21 G0 X1\nM2\n"
                                        << "1:8+2 work_offset_missing";
        QTest::newRow("no length offset") << "linuxcnc" << begin + "T1 M6\nG0 Z5\nM2\n"
                                          << "3:4+2 length_offset_missing";
        QTest::newRow("length offset") << "linuxcnc" << begin + "T1 M6\nG43 H1\nG0 Z5\nM2\n"
                                       << "";
        QTest::newRow("feed above the machine's") << "linuxcnc" << begin + "G0 X0 Y0 Z0\nG1 X1 F2001\nM2\n"
                                                  << "3:4+2 feed_above_machine";
        QTest::newRow("inverse time above the machine's") << "linuxcnc" << begin + "G0 X0 Y0 Z0\nG93 G1 X1 F2001\nM2\n"
                                                          << "3:8+2 feed_above_machine";
        QTest::newRow("spindle too fast") << "linuxcnc" << begin + "S24001 M3\nM2\n"
                                          << "2:1+6 spindle_beyond_machine";
        QTest::newRow("behind the end") << "linuxcnc" << begin + "M2\nsee you\n"
                                        << "";
        QTest::newRow("behind the end of GRBL") << "grbl" << begin + "M2\nsee you\n"
                                                << "3:1+1 number_missing";
        QTest::newRow("% behind a comment") << "linuxcnc"
                                            << "(job)\n%\n" + begin + "M2\n"
                                            << "2:1+1 percent_misplaced";
        QTest::newRow("five M words") << "linuxcnc" << begin + "M5 M9 M48 M1 M6\nM2\n"
                                      << "2:14+2 too_many_m_words";
        QTest::newRow("mist on GRBL") << "grbl" << begin + "M7\nM2\n"
                                      << "2:1+2 code_not_read";
    }
    void whatAControlRejectsIsMarked() {
        QFETCH(QString, control);
        QFETCH(QString, text);
        QFETCH(QString, mark);
        const std::vector<LintMark> marks = marksOf(text, control.toLatin1().constData());
        QStringList found;
        for (const LintMark& one : marks) found << describe(one);
        QCOMPARE(found, mark.isEmpty() ? QStringList() : QStringList(mark));
    }

    void allFaultsAreFound() {
        const std::vector<LintMark> marks = marksOf("G21 G54\nG0 X1 U1\nG0 Y\n(a\nG7\nG0 X2\nM2\n", "linuxcnc");
        QStringList found;
        for (const LintMark& one : marks) found << describe(one);
        QCOMPARE(found, (QStringList{"2:7+2 word_not_read", "3:4+1 number_missing", "4:1+1 comment_not_closed",
                                     "5:1+2 code_not_read"}));
    }

    void whatTheParserRefusesHasAMark() {
        QVERIFY(rc::check("a text is an error to both or to none", [] {
            const auto words = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
                "G0 ", "G1 ", "G2 ", "G91 ", "G90 ", "G18 ", "G20 ", "X1", "Y-2.5", "Z.5", "I1", "K-1", "F9", "\n",
                "M6", "T1", "(c)", "%", "/", "M2\n", "G43", "H1", "G81", "R2", "L3", "#1=", "[1+", "2]", "G92", "G10",
                "P1", "G28", "G53", "S100", "M3", "G93", "G4", "O1", "N1"));
            std::string text;
            for (const std::string& word : words) text += word;
            for (const Control& control : controls()) {
                const auto program = parseProgram(text, "job", control);
                bool refused = false;
                for (const LintMark& mark : lint(text, {&control, nullptr}))
                    refused =
                        refused || (mark.severity == LintSeverity::error && mark.problem != ProgramProblem::endMissing);
                RC_ASSERT(refused == !program);
            }
        }));
    }

    void whatATerminalWouldObeyIsShownByItsBytes_data() {
        QTest::addColumn<QByteArray>("written");
        QTest::addColumn<QString>("shown");
        QTest::newRow("escape") << QByteArray("\x1b[2J") << "\\x1b";
        QTest::newRow("no UTF-8") << QByteArray("\xff\xfe") << "\\xff";
        QTest::newRow("half a letter") << QByteArray("\xc3") << "\\xc3";
        QTest::newRow("a letter") << QByteArray("\xc3\xa4") << QString(QChar(0xE4));
        QTest::newRow("control sequence introducer") << QByteArray("\xc2\x9b") << "\\xc2\\x9b";
        QTest::newRow("written from the right") << QByteArray("\xe2\x80\xae") << "\\xe2\\x80\\xae";
        QTest::newRow("delete") << QByteArray("\x7f") << "\\x7f";
    }
    void whatATerminalWouldObeyIsShownByItsBytes() {
        QFETCH(QByteArray, written);
        QFETCH(QString, shown);
        const std::vector<LintMark> marks = lint("G21 G54\nG0 X1 " + written.toStdString() + "\nM2\n", {});
        QCOMPARE(marks.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(marks.front().words), shown);
        QVERIFY(QString::fromStdString(marks.front().text).endsWith(": " + shown));
    }

    void longWordsAreCut() {
        const std::string digits(300, '1');
        QCOMPARE(QString::fromStdString(shownWords("X" + digits, 1, 40)), QString(40, '1'));
        QCOMPARE(QString::fromStdString(shownWords("X" + digits, 1, 300)), QString(40, '1') + QChar(0x2026));
        QCOMPARE(QString::fromStdString(shownWords(std::string(300, '\a'), 0, 300)),
                 QString("\\x07").repeated(10) + QChar(0x2026));
        QCOMPARE(QString::fromStdString(shownWords("X1", 2, 5)), QString());
        QCOMPARE(QString::fromStdString(shownWords("X1", 7, 5)), QString());
    }

    void anyMessageCanBePrinted() {
        const auto isPrintable = [](const std::string& text) {
            const QString read = QString::fromStdString(text);
            if (read.toStdString() != text || read.size() > 160) return false; // not UTF-8, or not a message
            return std::ranges::all_of(read.toUcs4(), [](uint point) {
                const QChar::Category kind = QChar::category(point);
                return kind != QChar::Other_Control && kind != QChar::Separator_Line &&
                       kind != QChar::Separator_Paragraph && !(point >= 0x202A && point <= 0x202E);
            });
        };
        QVERIFY(rc::check("any bytes, some where words are expected", [&] {
            const auto bytes = *rc::gen::container<std::vector<std::uint8_t>>(rc::gen::arbitrary<std::uint8_t>());
            std::string text = *rc::gen::element<std::string>("", "G0 X[", "G0 X1(", "#", "G", "N1 ", "G0 X#<");
            for (const std::uint8_t byte : bytes) text += static_cast<char>(byte);
            text += *rc::gen::element<std::string>("", "]", std::string(400, '['), std::string(400, '\x1b'));
            for (const Control& control : controls()) {
                for (const LintMark& mark : lint(text, {&control, nullptr}))
                    RC_ASSERT(isPrintable(mark.text) && isPrintable(mark.words));
                const auto program = parseProgram(text, "job", control);
                if (!program) RC_ASSERT(isPrintable(program.error().detail));
            }
        }));
    }

    void noTextBringsItDown() {
        QVERIFY(rc::check("marks lie in the text", [](const std::string& text) {
            const auto ends = std::ranges::count_if(text, [](char c) { return c == '\n' || c == '\r'; });
            const auto lines = static_cast<std::size_t>(ends) + 1;
            for (const Control& control : controls())
                for (const LintMark& mark : lint(text, {&control, nullptr}))
                    RC_ASSERT(mark.line >= 1 && mark.line <= lines && mark.column >= 1 && mark.length >= 1);
        }));
    }
};

BURIN_TEST(TestLint, QCoreApplication)

} // namespace burin::tst_lint

#include "tst_lint.moc"
