// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace burin::tst_path_comparison_command {

/// Paths and their versions are compared from the command line.
class PathComparisonTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const ProgramRun embedded =
            run({"embed", BURIN_SOURCE_DIRECTORY "/resources/samples/mouse.step", "-o", in("p.burin"), "--voxel", "1"});
        QCOMPARE(embedded.status, 0);
        // Along X, 20 mm; the second one 0.3 mm beside it, and 10 mm longer.
        write("first.nc", "G21 G90 G17 G94 G54\nM3 S9000\nG0 X-60 Y0\nZ5\nG1 Z-2 F150\nX-40 F480\nG0 Z20\nM30\n");
        write("second.nc", "G21 G90 G17 G94 G54\nM3 S9000\nG0 X-60 Y0.3\nZ5\nG1 Z-2 F150\nX-30 F240\nG0 Z20\nM30\n");
        for (const char* file : {"first.nc", "second.nc"}) {
            const ProgramRun made = run({"path", in("p.burin"), "import", in(file), "--tool", "flat-6"});
            QVERIFY2(made.status == 0, made.messages.constData());
        }
    }

    void twoPathsAreCompared() {
        const ProgramRun told = run({"path", in("p.burin"), "compare", "1", "2", "--tolerance", "0.1"});
        QVERIFY2(told.status == 0, told.messages.constData());
        const QJsonObject first = told.json()["first"].toObject(), second = told.json()["second"].toObject();
        QCOMPARE(told.json()["tolerance_mm"].toDouble(), 0.1);
        QCOMPARE(first["name"].toString(), QStringLiteral("first.nc"));
        QCOMPARE(second["id"].toInt(), 2);
        QVERIFY(near(first["cutting_mm"].toDouble(), 20.0) && near(second["cutting_mm"].toDouble(), 30.0));
        QVERIFY(near(first["deviation"]["largest_mm"].toDouble(), 0.3));
        QVERIFY(near(first["deviation"]["mean_mm"].toDouble(), 0.3));
        QVERIFY(near(first["deviation"]["farther_share"].toDouble(), 1.0));
        // The end that is longer is as far from the end of the other one.
        QVERIFY(near(second["deviation"]["largest_mm"].toDouble(), std::hypot(10.0, 0.3)));
        QVERIFY(near(second["deviation"]["farther_mm"].toDouble(), 30.0));
        const double slower = second["time_at_feed_s"].toDouble() - first["time_at_feed_s"].toDouble();
        QVERIFY2(near(slower, 60.0 * (30.0 / 240.0 - 20.0 / 480.0)), told.output.constData());
        const ProgramRun wide = run({"path", in("p.burin"), "compare", "1", "2", "--tolerance", "0.31"});
        QCOMPARE(wide.json()["first"]["deviation"]["farther_mm"].toDouble(), 0.0);
    }

    void aPathIsComparedWithItselfWithoutAnEdit() {
        const QString file = in("edited.burin");
        QVERIFY(QFile::copy(in("p.burin"), file));
        const ProgramRun applied =
            run({"path", file, "apply", "1", "--edit", R"({"edit": "offset", "distance_mm": 0.25})"});
        QVERIFY2(applied.status == 0, applied.messages.constData());
        const ProgramRun told = run({"path", file, "compare", "1", "--without", "0"});
        QVERIFY2(told.status == 0, told.messages.constData());
        QCOMPARE(told.json()["second"]["variation"]["edit"].toString(), QStringLiteral("offset"));
        const double apart = told.json()["first"]["deviation"]["largest_mm"].toDouble();
        QVERIFY2(std::abs(apart - 0.25) < 0.002, told.output.constData());
        const ProgramRun recorded = run({"path", file, "compare", "1", "--recorded"});
        QVERIFY2(recorded.status == 0, recorded.messages.constData());
        QCOMPARE(recorded.json()["second"]["variation"]["recorded"].toBool(), true);
        QVERIFY(std::abs(recorded.json()["first"]["deviation"]["mean_mm"].toDouble() - 0.25) < 0.002);
        const ProgramRun spoken = runBurin({"path", file, "compare", "1", "--recorded"});
        QVERIFY2(spoken.output.contains("at most 0.25"), spoken.output.constData());
    }

    void whatIsWrongIsSaid() {
        const auto refused = [&](QStringList further, const char* text) {
            const ProgramRun made = run(QStringList{"path", in("p.burin"), "compare"} + further);
            QVERIFY2(made.status != 0, qPrintable(further.join(' ')));
            QVERIFY2(made.messages.contains(text), made.messages.constData());
        };
        refused({"1"}, "--recorded");
        refused({"1", "7"}, "7");
        refused({"9", "1"}, "9");
        refused({"1", "--without", "99"}, "99");
        refused({"1", "--without", "1.5"}, "1.5");
        refused({"1", "2", "--recorded"}, "--recorded");
        refused({"1", "2", "--tolerance", "0"}, "--tolerance");
    }

private:
    QString in(const QString& name) const { return folder_.filePath(name); }
    static ProgramRun run(QStringList arguments) { return runBurin(arguments << "--json"); }
    static bool near(double value, double expected) { return std::abs(value - expected) < 1e-6; }
    void write(const QString& name, const QByteArray& text) const {
        QFile file(in(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    }

    QTemporaryDir folder_;
};

BURIN_TEST(PathComparisonTest, QCoreApplication)

} // namespace burin::tst_path_comparison_command

#include "tst_path_comparison.moc"
