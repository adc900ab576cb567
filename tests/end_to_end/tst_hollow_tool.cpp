// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"

#include "core/base/units.h"
#include "tests/core/geometry/shapes.h"
#include "tests/places.h"
#include "tests/stl_text.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace burin::tst_hollow_tool {

/// A core drill of 12 × 8 mm, 20 mm long, on the command line: made of a model, milled with, replayed, posted,
/// verified.
class HollowToolTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        qputenv("XDG_DATA_HOME", in("data").toUtf8());
        QVERIFY(write("tube.stl", testing::stlText(shapes::tube(6.0, 4.0, 20.0, 360), "tube")));
        QVERIFY(write("bar.stl", testing::stlText(shapes::box({-3.0, -4.0, 0.0}, {3.0, 4.0, 20.0}), "bar")));
        const ProgramRun embedded = run({"embed", BURIN_FIXTURES "/models/red-cube-blue-cylinder.step", "-o",
                                         in("p.burin"), "--voxel", "0.5", "--margin", "10"});
        QVERIFY2(embedded.status == 0, embedded.messages.constData());
    }

    void theAnswerStatesTheHollow() {
        const ProgramRun made = run({"tools", "shape", "core", in("tube.stl"), "--like", "flat-10", "--number", "32"});
        QVERIFY2(made.status == 0, made.messages.constData());
        const QJsonObject answer = made.json();
        QVERIFY(answer["turns"].toBool());
        QVERIFY(std::abs(answer["diameter_mm"].toDouble() - 12.0) < 0.011);
        QVERIFY(std::abs(answer["hollow_width_mm"].toDouble() - 8.0) < 0.006);
        QVERIFY(std::abs(answer["hollow_depth_mm"].toDouble() - 20.0) < 0.001);
        QVERIFY(answer["hollow_excess_mm"].toDouble() < 0.007);
        const QByteArray told =
            runBurin({"tools", "shape", "core", in("tube.stl"), "--like", "flat-10", "--number", "32", "--replace"})
                .output;
        QVERIFY2(told.contains("hollow, ") && told.contains("20.00 mm deep"), told.constData());
        const QJsonObject cutter = run({"tools", "show", "core"}).json()["cutter"].toObject();
        QVERIFY(cutter.contains("section") && !cutter.contains("turns") && !cutter.contains("flutes_mesh"));
        QCOMPARE(run({"tools", "copy", "core", "again"}).status, 0);
        QCOMPARE(run({"tools", "show", "again"}).json()["cutter"].toObject(), cutter);
        // A tool without a hollow is a profile, as before.
        const ProgramRun bar = run({"tools", "shape", "bar", in("bar.stl"), "--like", "flat-10"});
        QVERIFY(bar.status == 0 && !bar.json().contains("hollow_width_mm"));
        QVERIFY(!run({"tools", "show", "bar"}).json()["cutter"].toObject().contains("section"));
    }

    /// By hand: straight down onto the part and up again. The same workpiece, to the last run unit, from the recording.
    void replayingItsTakeGivesTheSameWorkpiece() {
        QByteArray trace = "time_s,x_mm,y_mm,z_mm,qw,qx,qy,qz,buttons\n";
        for (int i = 0; i < 3000; ++i) {
            const double time = 0.001 * i, depth = 36.0 * (1.0 - std::abs(time / 1.5 - 1.0)); // mm, down and up
            trace +=
                QByteArray::number(time, 'f', 3) + ",0,0," + QByteArray::number(30.0 - depth, 'f', 4) + ",1,0,0,0,0\n";
        }
        QVERIFY(write("hand.csv", trace));
        const QString stock = hash();
        const ProgramRun milled = run({"mill", in("p.burin"), "--tool", "core", "--stylus", "trace:" + in("hand.csv")});
        QVERIFY2(milled.status == 0, milled.messages.constData());
        const QJsonObject take = milled.json()["takes"].toArray()[0].toObject();
        QVERIFY2(take["removed_mm3"].toDouble() > 0.5 * pi * 20.0, milled.output.constData());
        QVERIFY(std::abs(take["removed_mm3"].toDouble() - take["workpiece_drop_mm3"].toDouble()) < 1e-6);
        QVERIFY(take["cutting_force_max_n"].toDouble() > 0.0);
        const QString left = milled.json()["workpiece_hash"].toString();
        QVERIFY(left != stock);
        QCOMPARE(run({"take", "off", in("p.burin"), "1"}).status, 0);
        QCOMPARE(hash(), stock);
        QCOMPARE(run({"take", "on", in("p.burin"), "1"}).status, 0);
        QCOMPARE(hash(), left);
    }

    /// Its path has feeds, ramps and links like that of any tool that turns, and is posted.
    void itIsPosted() {
        const ProgramRun made = run({"path", in("p.burin"), "new"});
        QVERIFY2(made.status == 0, made.messages.constData());
        const ProgramRun posted = run({"post", in("p.burin"), "-o", in("p.ngc"), "--override", "test of the text"});
        QVERIFY2(posted.status == 0, posted.messages.constData());
        QFile file(in("p.ngc"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray text = file.readAll();
        QVERIFY2(text.contains("T32") && text.contains("M3") && text.contains("F"), text.constData());
    }

    /// A program: 3 mm down and up again leaves the core of 8 mm; a slot through all of the stock is as wide as the
    /// tool. Its axis can't lean.
    void aProgramIsCheckedWithItsHollow() {
        const auto removed = [&](const QByteArray& moves) {
            if (!write("cut.ngc",
                       "G21 G90 G17 G94 G54\nT32 M6\nG43 H32\nS3000 M3\nG0 X0 Y0 Z20\n" + moves + "G0 Z20\nM5\nM2\n"))
                return QJsonObject();
            const ProgramRun checked =
                run({"verify", in("cut.ngc"), "--project", in("fresh.burin"), "--tool", "core", "--exact", "0"});
            return checked.json();
        };
        QCOMPARE(run({"embed", BURIN_FIXTURES "/models/red-cube-blue-cylinder.step", "-o", in("fresh.burin"), "--voxel",
                      "0.25", "--margin", "10"})
                     .status,
                 0);
        const QJsonObject core = removed("G1 Z-3 F100\n");
        const double ring = 3.0 * pi * 20.0;
        QVERIFY2(std::abs(core["removed_mm3"].toDouble() / ring - 1.0) < 0.015,
                 qPrintable(QString::number(core["removed_mm3"].toDouble())));
        QVERIFY(!kindsOf(core).contains("spindle_on") && !kindsOf(core).contains("spindle_off"));
        QVERIFY(!kindsOf(core).contains("gouge") && !kindsOf(core).contains("centre_plunge"));
        const QJsonObject slot = removed("G1 Z-3 F100\nX9\n");
        const double wide = 3.0 * (9.0 * 12.0 + pi * 36.0);
        QVERIFY2(std::abs(slot["removed_mm3"].toDouble() / wide - 1.0) < 0.015,
                 qPrintable(QString::number(slot["removed_mm3"].toDouble())));
        const ProgramRun tilted = run(
            {"mill", in("fresh.burin"), "--tool", "core", "--stylus", "trace:" + in("hand.csv"), "--axis", "1,0,1"});
        QVERIFY2(tilted.status != 0 && tilted.messages.contains("hollow") && tilted.messages.count('\n') == 1,
                 tilted.messages.constData());
    }

private:
    QString in(const char* name) const { return folder_.filePath(name); }
    static ProgramRun run(QStringList arguments) { return runBurin(arguments << "--json"); }
    bool write(const char* name, const QByteArray& text) const {
        QFile file(in(name));
        return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
    }
    QString hash() const {
        return run({"volume", "export", in("p.burin"), "-o", in("volume.srle")}).json()["hash"].toString();
    }
    static QSet<QString> kindsOf(const QJsonObject& report) {
        QSet<QString> kinds;
        for (const QJsonValue& found : report["findings"].toArray()) kinds << found.toObject()["kind"].toString();
        return kinds;
    }

    QTemporaryDir folder_;
};

BURIN_TEST(HollowToolTest, QCoreApplication)

} // namespace burin::tst_hollow_tool

#include "tst_hollow_tool.moc"
