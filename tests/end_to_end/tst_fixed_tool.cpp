// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"

#include "tests/core/geometry/shapes.h"
#include "tests/places.h"
#include "tests/stl_text.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace burin::tst_fixed_tool {

/// A scraper of 8 × 2 × 60 mm on the command line: made, milled with, replayed, verified, and refused where a tool has
/// to turn.
class FixedToolTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        qputenv("XDG_DATA_HOME", in("data").toUtf8());
        const TriangleMesh blade = shapes::box({-4.0, -1.0, 0.0}, {4.0, 1.0, 60.0});
        QVERIFY(write("blade.stl", testing::stlText(blade, "blade")));
        for (const auto& [id, angle] : {std::pair{"along", "0"}, {"across", "90"}}) {
            const ProgramRun made = run({"tools", "shape", id, in("blade.stl"), "--like", "flat-10", "--fixed",
                                         "--angle", angle, "--number", "31"});
            QVERIFY2(made.status == 0, made.messages.constData());
            QVERIFY(!made.json()["turns"].toBool(true));
            // Pythagoras: the profile that keeps it out of the part
            QVERIFY(std::abs(made.json()["diameter_mm"].toDouble() - std::sqrt(68.0)) < 0.011);
        }
        const ProgramRun embedded = run({"embed", BURIN_FIXTURES "/models/red-cube-blue-cylinder.step", "-o",
                                         in("p.burin"), "--voxel", "0.5", "--margin", "4"});
        QVERIFY2(embedded.status == 0, embedded.messages.constData());
    }

    /// Its file is read back as it was written, and a broken one names the key.
    void itsFileKeepsTheModel() {
        const QJsonObject shown = run({"tools", "show", "across"}).json();
        const QJsonObject cutter = shown["cutter"].toObject();
        QCOMPARE(cutter["turns"].toBool(true), false);
        QCOMPARE(cutter["angle_deg"].toDouble(), 90.0);
        QCOMPARE(cutter["flutes_mesh"].toObject()["triangles"].toArray().size(), 36);
        QCOMPARE(run({"tools", "copy", "across", "again"}).status, 0);
        QCOMPARE(run({"tools", "show", "again"}).json()["cutter"].toObject(), cutter);
        QJsonObject broken = shown, other = cutter, mesh = cutter["flutes_mesh"].toObject();
        QJsonArray triangles = mesh["triangles"].toArray();
        triangles.removeLast();
        triangles.removeLast();
        triangles.removeLast();
        mesh["triangles"] = triangles;
        other["flutes_mesh"] = mesh;
        broken["cutter"] = other;
        broken["id"] = "broken";
        QVERIFY(write("broken.json", QJsonDocument(broken).toJson()));
        const ProgramRun refused = run({"tools", "add", in("broken.json")});
        QVERIFY(refused.status != 0 && refused.messages.contains("flutes_mesh"));
    }

    /// The same workpiece, to the last run unit: as the hand left it, and cut again from the recording.
    void replayingItsTakeGivesTheSameWorkpiece() {
        QByteArray trace = "time_s,x_mm,y_mm,z_mm,qw,qx,qy,qz,buttons\n";
        for (int i = 0; i < 4000; ++i) {
            const double time = 0.001 * i;
            // Device frame: to and fro over the stock, from above down to the part
            const double place[] = {28.0 * std::sin(4.2 * time), 9.0 * std::cos(2.9 * time), 30.0 - 9.0 * time};
            trace += QByteArray::number(time, 'f', 3);
            for (const double each : place) trace += ',' + QByteArray::number(each, 'f', 4);
            trace += ",1,0,0,0,0\n";
        }
        QVERIFY(write("hand.csv", trace));
        const QString stock = hash({});
        const ProgramRun milled =
            run({"mill", in("p.burin"), "--tool", "across", "--stylus", "trace:" + in("hand.csv")});
        QVERIFY2(milled.status == 0, milled.messages.constData());
        const QJsonObject take = milled.json()["takes"].toArray()[0].toObject();
        QVERIFY(take["removed_mm3"].toDouble() > 100.0);
        QVERIFY(std::abs(take["removed_mm3"].toDouble() - take["workpiece_drop_mm3"].toDouble()) < 1e-6);
        QVERIFY(take["cutting_force_max_n"].toDouble() > 0.0);
        const QString left = milled.json()["workpiece_hash"].toString();
        QVERIFY(left != stock);
        QCOMPARE(run({"take", "off", in("p.burin"), "1"}).status, 0);
        QCOMPARE(hash({}), stock);
        QCOMPARE(run({"take", "on", in("p.burin"), "1"}).status, 0);
        QCOMPARE(hash({}), left);
        QCOMPARE(hash({"--at", "1"}), left);
    }

    /// Above the part the slots have the width of the blade along or across the motion: 2 and 8 mm. Through the part
    /// the check finds gouges. The spindle has to stand still.
    void aProgramIsCheckedWithItsSolid() {
        const QByteArray slot =
            "G21 G90 G17 G94 G54\nT31 M6\nG43 H31\n%1G0 Z20\nG0 X-60 Y0\nG0 Z-1\nG1 X60 F300\nG0 Z20\n"
            "M5\nM2\n";
        const auto removed = [&](const char* tool, const QByteArray& spindle, const char* depth = "Z-1") {
            QByteArray text = slot;
            text.replace("%1", spindle).replace("Z-1\n", QByteArray(depth) + '\n');
            if (!write("slot.ngc", text)) return QJsonObject();
            return run({"verify", in("slot.ngc"), "--project", in("p.burin"), "--tool", tool, "--exact", "0",
                        "--workpiece", in("then.srle")})
                .json();
        };
        const QJsonObject along = removed("along", ""), across = removed("across", "");
        const double narrow = along["removed_mm3"].toDouble(), wide = across["removed_mm3"].toDouble();
        // The stock is 66 voxels of 0.5 mm long: 33 mm × 1 mm × width.
        QVERIFY2(std::abs(narrow - 66.0) < 0.01 && std::abs(wide - 264.0) < 0.01,
                 qPrintable(QStringLiteral("%1 %2").arg(narrow).arg(wide)));
        QVERIFY(!kindsOf(along).contains("spindle_off") && !kindsOf(along).contains("spindle_on"));
        QVERIFY(!kindsOf(along).contains("gouge"));
        const QJsonObject turning = removed("along", "S1000 M3\n");
        QVERIFY(kindsOf(turning).contains("spindle_on"));
        QCOMPARE(turning["workpiece_hash"].toString(), along["workpiece_hash"].toString());
        QVERIFY(kindsOf(removed("across", "", "Z-8")).contains("gouge"));
    }

    /// What needs a tool that turns is refused with one sentence, and changes nothing.
    void whatNeedsASpindleIsRefused() {
        QCOMPARE(run({"path", in("p.burin"), "new"}).status, 0);
        const ProgramRun shown = run({"path", in("p.burin"), "show", "1"});
        QVERIFY2(shown.status == 0, shown.messages.constData());
        for (const QStringList& wrong :
             {QStringList{"mill", in("p.burin"), "--tool", "along"},
              {"mill", in("p.burin"), "--tool", "along", "--stylus", "trace:" + in("hand.csv"), "--axis", "1,0,1"},
              {"post", in("p.burin"), "-o", in("p.ngc")}}) {
            const ProgramRun refused = run(wrong);
            QVERIFY2(refused.status == 2 || refused.status == 3, qPrintable(wrong.join(' ')));
            QVERIFY2(refused.messages.contains("turn") && refused.messages.count('\n') == 1,
                     refused.messages.constData());
        }
        QVERIFY(!QFile::exists(in("p.ngc")));
        QCOMPARE(run({"path", in("p.burin"), "apply", "1", "--edit", R"({"edit": "set-feed"})", "--place", "6"}).status,
                 0);
        const ProgramRun fed = run({"path", in("p.burin"), "show", "1"});
        QVERIFY2(fed.status != 0 && fed.messages.contains("set-feed") && fed.messages.contains("doesn't turn"),
                 fed.messages.constData());
    }

private:
    QString in(const char* name) const { return folder_.filePath(name); }
    static ProgramRun run(QStringList arguments) { return runBurin(arguments << "--json"); }
    bool write(const char* name, const QByteArray& text) const {
        QFile file(in(name));
        return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
    }
    QString hash(const QStringList& more) const {
        return run(QStringList{"volume", "export", in("p.burin"), "-o", in("volume.srle")} + more)
            .json()["hash"]
            .toString();
    }
    static QSet<QString> kindsOf(const QJsonObject& report) {
        QSet<QString> kinds;
        for (const QJsonValue& found : report["findings"].toArray()) kinds << found.toObject()["kind"].toString();
        return kinds;
    }

    QTemporaryDir folder_;
};

BURIN_TEST(FixedToolTest, QCoreApplication)

} // namespace burin::tst_fixed_tool

#include "tst_fixed_tool.moc"
