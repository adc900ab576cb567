// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "canonical_moves.h"
#include "program_run.h"

#include "core/tool/tool_library.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

namespace burin::tst_program_zero {

namespace {

glm::dvec3 vectorOf(const QJsonValue& value) {
    const QJsonArray numbers = value.toArray();
    return {numbers[0].toDouble(), numbers[1].toDouble(), numbers[2].toDouble()};
}

} // namespace

/// Program zero and its work offset, from the command line. Oracle: LinuxCNC's interpreter.
class ProgramZeroTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QCOMPARE(runBurin({"embed", BURIN_FIXTURES "/models/cube.brep", "-o", in("p.burin"), "--voxel", "0.5"}).status,
                 0);
        QCOMPARE(runBurin({"mill", in("p.burin"), "--intent", "scribble", "--seconds", "2"}).status, 0);
        QCOMPARE(runBurin({"path", in("p.burin"), "new"}).status, 0);
        post("middle.ngc");
    }

    /// The same tool positions in the stock: the moves differ by the vector between both zeros, apart from rounding.
    void theProgramMovesWithItsZero_data() {
        QTest::addColumn<QString>("zero");
        QTest::newRow("a corner of the top") << "stock:low,low,high";
        QTest::newRow("below the part") << "part:middle,middle,low";
        QTest::newRow("a vertex of the part") << "near:0.5,0.5,9";
        QTest::newRow("stated") << "3.25,-4.5,17";
    }
    void theProgramMovesWithItsZero() {
        QFETCH(QString, zero);
        const glm::dvec3 before = zeroIn({});
        const ProgramRun run = runBurin({"setup", in("p.burin"), "--zero", zero, "--json"});
        QVERIFY2(run.status == 0, run.messages.constData());
        const glm::dvec3 way = before - zeroIn({});
        post("moved.ngc");
        const std::vector<CanonicalMove> one = moves("middle.ngc"), other = moves("moved.ngc");
        QVERIFY(one.size() > 20);
        // Arcs are fitted to rounded values, so only the lowest and outermost positions of the tool are compared.
        for (int axis = 0; axis < 3; ++axis)
            for (const bool low : {true, false}) {
                if (axis == 2 && !low) continue; // clearance heights are relative to the zero
                QVERIFY2(std::abs(reach(other, axis, low) - reach(one, axis, low) - way[axis]) < 0.003,
                         qPrintable(QString("axis %1").arg(axis)));
            }
        QCOMPARE(runBurin({"setup", in("p.burin"), "--zero", "stock:middle,middle,high"}).status, 0);
        QCOMPARE(zeroIn({}), before);
    }

    /// Three sides of the stock make its corner zero: the cube of 10 mm in its margins of 5 mm, from -5 to 15 mm.
    void theCornerOfTheStockIsTouchedOff() {
        const QStringList setup{"setup", in("p.burin"), "--json"};
        const ProgramRun run =
            runBurin(setup + QStringList{"--touch=-30,5,5=x", "--touch=5,40,5=-y", "--touch=5,5,60=-z"});
        QVERIFY2(run.status == 0, run.messages.constData());
        QCOMPARE(zeroIn({}), glm::dvec3(-5.0, 15.0, 15.0));
        const ProgramRun inside = runBurin(setup + QStringList{"--touch=5,5,5=x"});
        QVERIFY2(inside.status != 0 && inside.messages.contains("clear of the stock"), inside.messages.constData());
        const ProgramRun aside = runBurin(setup + QStringList{"--touch=-30,5,13=x"});
        QVERIFY2(aside.status != 0 && aside.messages.contains("squarely"), aside.messages.constData());
        const ProgramRun wrong = runBurin(setup + QStringList{"--touch=1,2=x"});
        QVERIFY2(wrong.status != 0 && wrong.messages.contains("X,Y,Z=AXIS"), wrong.messages.constData());
        QCOMPARE(zeroIn({}), glm::dvec3(-5.0, 15.0, 15.0));
        QCOMPARE(runBurin({"setup", in("p.burin"), "--zero", "stock:middle,middle,high"}).status, 0);
    }

    void eachDialectCallsTheWorkOffsetItsOwnWay_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("dialect");
        QTest::addColumn<QString>("words");
        QTest::newRow("LinuxCNC") << "G57"
                                  << "linuxcnc"
                                  << "G57";
        QTest::newRow("LinuxCNC, the last") << "G59.3"
                                            << "linuxcnc"
                                            << "G59.3";
        QTest::newRow("Fanuc, further") << "P7"
                                        << "fanuc"
                                        << "G54.1 P7";
        QTest::newRow("Haas, further") << "P99"
                                       << "haas"
                                       << "G154 P99";
        QTest::newRow("GRBL") << "G59"
                              << "grbl"
                              << "G59";
    }
    void eachDialectCallsTheWorkOffsetItsOwnWay() {
        QFETCH(QString, name);
        QFETCH(QString, dialect);
        QFETCH(QString, words);
        QCOMPARE(runBurin({"setup", in("p.burin"), "--work-offset", name, "--dialect", dialect}).status, 0);
        post("offset.nc");
        const QString text = contentOf(in("offset.nc"));
        QVERIFY2(text.contains(QRegularExpression("(^|[\\n ])" + QRegularExpression::escape(words) + "([\\n ]|$)")),
                 qPrintable(text.left(900)));
        // Some controls do not accept a colon in a comment.
        QVERIFY(text.contains(QRegularExpression("work offset.? +" + QRegularExpression::escape(name),
                                                 QRegularExpression::CaseInsensitiveOption)));
    }

    /// A control without the work offset is reported before there is a program, with the offsets that it has.
    void aWorkOffsetThatTheControlLacksIsRefused() {
        QCOMPARE(runBurin({"setup", in("p.burin"), "--work-offset", "G59.1", "--dialect", "mach"}).status, 0);
        const ProgramRun run = runBurin({"post", in("p.burin"), "-o", in("none.ngc")});
        QVERIFY(run.status != 0);
        QVERIFY2(run.messages.contains("G59.1") && run.messages.contains("G54 to G59"), run.messages.constData());
        QVERIFY(!QFile::exists(in("none.ngc")));
    }

    /// A program with another work offset would mill beside the part.
    void aProgramOfAnotherWorkOffsetIsFound() {
        QCOMPARE(runBurin({"setup", in("p.burin"), "--work-offset", "G55", "--dialect", "linuxcnc"}).status, 0);
        const ProgramRun run =
            runBurin({"verify", in("middle.ngc"), "--project", in("p.burin"), "--json", "--exact", "0"});
        QCOMPARE(run.status, 1);
        QVERIFY2(run.output.contains("other_work_offset"), run.output.constData());
        post("g55.ngc");
        QCOMPARE(runBurin({"verify", in("g55.ngc"), "--project", in("p.burin"), "--exact", "0"}).status, 0);
    }

    void refusalsSayWhy_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("said");
        QTest::newRow("no side") << QStringList{"--zero", "stock:low,low"} << QByteArray("low, middle or high");
        QTest::newRow("no reference") << QStringList{"--zero", "table:low,low,low"} << QByteArray("stock:X,Y,Z");
        QTest::newRow("no number") << QStringList{"--zero", "1,2,nan"} << QByteArray("stock:X,Y,Z");
        QTest::newRow("no work offset") << QStringList{"--work-offset", "G60"} << QByteArray("G54 to G59");
        QTest::newRow("outside the travel")
            << QStringList{"--travel", "9999,1,1"} << QByteArray("travel of the machine");
    }
    void refusalsSayWhy() {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, said);
        const QString before = contentOf(in("p.burin"));
        const ProgramRun run = runBurin(QStringList{"setup", in("p.burin")} + arguments);
        QCOMPARE(run.status, 2);
        QVERIFY2(run.messages.contains(said), run.messages.constData());
        QCOMPARE(run.messages.count('\n'), 1); // one sentence
        QCOMPARE(contentOf(in("p.burin")), before);
    }

private:
    QString in(const char* name) const { return folder_.filePath(name); }

    void post(const char* program) {
        const ProgramRun posted = runBurin({"post", in("p.burin"), "-o", in(program)});
        QVERIFY2(posted.status == 0, (posted.output + posted.messages).constData());
    }

    glm::dvec3 zeroIn(const QStringList& more) const {
        return vectorOf(runBurin(QStringList{"setup", in("p.burin"), "--json"} + more).json()["work_offset_mm"]);
    }

    std::vector<CanonicalMove> moves(const char* program) const {
        QTemporaryDir home;
        return canonicalMoves(in(program), home.path(), loadTool("ball-6").value().number, 6.0)
            .value_or(std::vector<CanonicalMove>());
    }

    /// The extreme coordinate of a program's cuts along an axis.
    static double reach(const std::vector<CanonicalMove>& moves, int axis, bool low) {
        double reached = low ? 1e9 : -1e9;
        for (const CanonicalMove& move : moves)
            if (!move.rapid) reached = low ? std::min(reached, move.to[axis]) : std::max(reached, move.to[axis]);
        return reached;
    }

    QTemporaryDir folder_;
};

BURIN_TEST(ProgramZeroTest, QCoreApplication)

} // namespace burin::tst_program_zero

#include "tst_program_zero.moc"
