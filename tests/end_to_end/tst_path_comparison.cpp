// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace burin::tst_path_comparison_command {

/// Compares paths and their versions from the command line.
class PathComparisonTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const ProgramRun embedded =
            run({"embed", BURIN_SOURCE_DIRECTORY "/resources/samples/mouse.step", "-o", in("p.burin"), "--voxel", "1"});
        QCOMPARE(embedded.status, 0);
        // Down by 7 mm at feed, then along X by 20 mm; the second one is offset by 0.3 mm and 10 mm longer.
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
        QVERIFY(near(first["cutting_mm"].toDouble(), 27.0) && near(second["cutting_mm"].toDouble(), 37.0));
        QVERIFY(near(first["deviation"]["largest_mm"].toDouble(), 0.3));
        QVERIFY(near(first["deviation"]["mean_mm"].toDouble(), 0.3));
        QVERIFY(near(first["deviation"]["farther_share"].toDouble(), 1.0));
        // The end of the longer path is that far from the end of the other one.
        QVERIFY(near(second["deviation"]["largest_mm"].toDouble(), std::hypot(10.0, 0.3)));
        QVERIFY(near(second["deviation"]["farther_mm"].toDouble(), 37.0));
        // At the same feed down; then along, and up again by 1 mm.
        const double slower = second["time_at_feed_s"].toDouble() - first["time_at_feed_s"].toDouble();
        QVERIFY2(near(slower, 60.0 * (31.0 / 240.0 - 21.0 / 480.0)), told.output.constData());
        const ProgramRun wide = run({"path", in("p.burin"), "compare", "1", "2", "--tolerance", "0.31"});
        QCOMPARE(deviation(wide, "farther_mm"), 0.0);
    }

    void aPathIsComparedWithItselfWithoutAnEdit() {
        const QString file = in("edited.burin");
        QVERIFY(QFile::copy(in("p.burin"), file));
        for (const char* edit : {R"({"edit": "hold-out"})", R"({"edit": "offset", "distance_mm": 0.25})"}) {
            const ProgramRun applied = run({"path", file, "apply", "1", "--edit", edit}); // before all others
            QVERIFY2(applied.status == 0, applied.messages.constData());
        }
        const ProgramRun told = run({"path", file, "compare", "1", "--without", "0"});
        QVERIFY2(told.status == 0, told.messages.constData());
        QCOMPARE(variation(told)["edit"].toString(), QStringLiteral("offset"));
        const double apart = deviation(told, "largest_mm");
        QVERIFY2(std::abs(apart - 0.25) < 0.002, told.output.constData());
        const ProgramRun recorded = run({"path", file, "compare", "1", "--recorded"});
        QVERIFY2(recorded.status == 0, recorded.messages.constData());
        QCOMPARE(variation(recorded)["recorded"].toBool(), true);
        QVERIFY(std::abs(deviation(recorded, "mean_mm") - 0.25) < 0.002);
        const ProgramRun spoken = runBurin({"path", file, "compare", "1", "--recorded"});
        QVERIFY2(spoken.output.contains("at most 0.25"), spoken.output.constData());
    }

    void whatIsWrongIsSaid() {
        const auto refused = [&](QStringList further, const char* text) {
            const ProgramRun made = run(QStringList{"path", in("p.burin"), "compare"} + further);
            QVERIFY2(made.status != 0, qPrintable(further.join(' ')));
            QVERIFY2(made.messages.contains(text), made.messages.constData());
        };
        // What is left of the edits has to keep what they promise.
        QVERIFY(QFile::copy(in("p.burin"), in("unsafe.burin")));
        for (const char* edit : {R"({"edit": "hold-out"})", R"({"edit": "offset"})"})
            QCOMPARE(run({"path", in("unsafe.burin"), "apply", "1", "--edit", edit}).status, 0);
        const ProgramRun unsafe = run({"path", in("unsafe.burin"), "compare", "1", "--without", "1"});
        QVERIFY2(unsafe.status != 0 && unsafe.messages.contains("Keep out"), unsafe.messages.constData());
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
    /// A value of the first path's deviation.
    static double deviation(const ProgramRun& run, const char* key) {
        const QJsonObject answer = run.json();
        return answer["first"]["deviation"][key].toDouble();
    }
    static QJsonObject variation(const ProgramRun& run) {
        const QJsonObject answer = run.json();
        return answer["second"]["variation"].toObject();
    }
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
