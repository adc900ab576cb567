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

namespace burin::tst_volume {

/// Volumes as files: the operations named in the paper, on the command line.
class VolumeTest : public QObject {
    Q_OBJECT
private slots:
    /// Two boxes of 10 mm that overlap by half: closed formulas.
    void operationsAreThoseOfBoxes() {
        makeBox("a.srle", 0, 10);
        makeBox("b.srle", 5, 15);
        makeBox("c.srle", 10, 20);
        const auto volume = [&](const char* operation) {
            const QString out = in("out.srle");
            const ProgramRun made = runBurin({"volume", operation, in("a.srle"), in("b.srle"), "-o", out});
            if (made.status != 0) qWarning("%s", made.messages.constData());
            return runBurin({"volume", "moments", out, "--json"}).json()["all"].toObject();
        };
        QCOMPARE(volume("union")["volume_mm3"].toDouble(), 1500.0);
        QCOMPARE(volume("intersection")["volume_mm3"].toDouble(), 500.0);
        const QJsonObject left = volume("difference");
        QCOMPARE(left["volume_mm3"].toDouble(), 500.0);
        QCOMPARE(left["centroid_mm"].toArray()[0].toDouble(), 2.5);
        const auto relation = [&](const char* other) {
            return runBurin({"volume", "relation", in("a.srle"), in(other), "--json"}).json()["relation"].toString();
        };
        QCOMPARE(relation("b.srle"), QString("intersecting"));
        QCOMPARE(relation("c.srle"), QString("adjacent"));
    }

    /// A block of 10 × 10 × 10 mm of oak: its mass, and the inertia of a box, m (b² + c²) / 12.
    void momentsAreThoseOfTheFormula() {
        makeBox("a.srle", 0, 10);
        const QJsonObject answer = runBurin({"volume", "moments", in("a.srle"), "--json"}).json();
        const QJsonObject oak = answer["materials"].toArray()[0].toObject();
        QCOMPARE(oak["id"].toString(), QString("oak"));
        QVERIFY(std::abs(oak["mass_g"].toDouble() - 0.69) < 1e-9);
        const double exact = 1000.0 * 200.0 / 12.0;
        QVERIFY(std::abs(oak["inertia_mm5"].toArray()[0].toArray()[0].toDouble() / exact - 1.0) < 1e-6);
    }

    /// A volume is unchanged after conversion to an array and back.
    void arraysComeBackAsTheyWent() {
        makeBox("a.srle", 0, 10);
        QCOMPARE(runBurin({"volume", "convert", in("a.srle"), "-o", in("a.nrrd")}).status, 0);
        QVERIFY(QFile::exists(in("a.table.json")));
        QCOMPARE(
            runBurin({"volume", "convert", in("a.nrrd"), "--table", in("a.table.json"), "-o", in("again.srle")}).status,
            0);
        const auto moments = [&](const char* name) {
            return runBurin({"volume", "moments", in(name), "--json"}).output;
        };
        QCOMPARE(moments("again.srle"), moments("a.srle"));
        QCOMPARE(runBurin({"volume", "turn", in("a.srle"), "--axis", "x", "-o", in("x.srle")}).status, 0);
        QCOMPARE(runBurin({"volume", "moments", in("x.srle"), "--json"}).json()["runs_along"].toString(), QString("x"));
        // The shell of 20 x 20 x 20 voxels.
        QCOMPARE(runBurin({"volume", "boundary", in("a.srle"), "-o", in("shell.srle")}).status, 0);
        const double shell = (20.0 * 20 * 20 - 18.0 * 18 * 18) / 8.0;
        QCOMPARE(runBurin({"volume", "moments", in("shell.srle"), "--json"})
                     .json()["all"]
                     .toObject()["volume_mm3"]
                     .toDouble(),
                 shell);
    }

    void theWorkpieceOfAProjectIsExported() {
        const QString project = in("p.burin");
        QCOMPARE(runBurin({"embed", BURIN_FIXTURES "/models/cube.brep", "-o", project, "--voxel", "0.5", "--margin",
                           "5", "--material", "machinable-wax"})
                     .status,
                 0);
        QCOMPARE(runBurin({"mill", project, "--fast", "--seconds", "5"}).status, 0);
        for (const char* name : {"w.stl", "w.ply", "w.3mf", "w.srle"}) {
            const ProgramRun run = runBurin({"volume", "export", project, "-o", in(name)});
            QVERIFY2(run.status == 0, run.messages);
            QVERIFY(QFile::exists(in(name)));
        }
        QCOMPARE(runBurin({"volume", "export", project, "--stock", "-o", in("s.srle")}).status, 0);
        const auto volume = [&](const char* name) {
            return runBurin({"volume", "moments", in(name), "--json"})
                .json()["all"]
                .toObject()["volume_mm3"]
                .toDouble();
        };
        QVERIFY(volume("w.srle") < volume("s.srle"));
        const ProgramRun read = runBurin({"import", in("w.stl"), "--json"});
        QCOMPARE(read.status, 0);
        const QJsonObject body = read.json()["bodies"].toArray()[0].toObject();
        QCOMPARE(body["open_edges"].toInt(), 0);
        QVERIFY(std::abs(body["volume_mm3"].toDouble() / volume("w.srle") - 1.0) < 0.01); // edges are bevelled
    }

    void badInputIsRefusedInOneSentence() {
        makeBox("a.srle", 0, 10);
        const auto refused = [&](const QStringList& arguments, const char* words) {
            const ProgramRun run = runBurin(QStringList{"volume"} + arguments);
            return run.status >= 2 && QString::fromUtf8(run.messages).contains(words) && run.messages.count('\n') == 1;
        };
        QVERIFY(refused({"convert", in("none.srle"), "-o", in("never.srle")}, "does not exist"));
        QVERIFY(refused({"convert", in("array.nrrd"), "-o", in("never.srle")}, "table"));
        QVERIFY(refused({"convert", in("a.srle"), "-o", in("x.fbx")}, ".3mf"));
        QVERIFY(refused({"moments", BURIN_FIXTURES "/models/cube.brep"}, "format"));
        QVERIFY(refused({"convert", in("a.srle"), "-o", in("a.srle")}, "--output"));
        QFile cut(in("a.srle"));
        QVERIFY(cut.open(QIODevice::ReadWrite) && cut.resize(cut.size() / 2));
        cut.close();
        QVERIFY(runBurin({"volume", "moments", in("a.srle")}).status != 0 ||
                runBurin({"volume", "moments", in("a.srle")}).messages.contains("damaged"));
        QVERIFY(!QFile::exists(in("never.srle")));
    }

private:
    QString in(const char* name) const { return folder_.filePath(name); }

    /// A box of oak, 10 mm along Y and Z, between two positions on X, in a common grid of 0.5 mm.
    void makeBox(const char* name, int from, int to) {
        QByteArray voxels;
        for (int z = 0; z < 20; ++z)
            for (int y = 0; y < 20; ++y)
                for (int x = 0; x < 40; ++x) voxels += x >= 2 * from && x < 2 * to ? '\1' : '\0';
        QFile array(in("array.nrrd")), table(in("table.json"));
        const QByteArray text =
            "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 40 20 20\nspace units: \"mm\" \"mm\" \"mm\"\n"
            "spacings: 0.5 0.5 0.5\nencoding: raw\n\n" +
            voxels;
        const QByteArray entries = R"({"entries": [{"value": 0, "material": null}, {"value": 1, "material": "oak"}]})";
        if (!array.open(QIODevice::WriteOnly) || array.write(text) != text.size() ||
            !table.open(QIODevice::WriteOnly) || table.write(entries) != entries.size())
            qFatal("no test file");
        array.close();
        table.close();
        const ProgramRun made =
            runBurin({"volume", "convert", array.fileName(), "--table", table.fileName(), "-o", in(name)});
        if (made.status != 0) qFatal("%s", made.messages.constData());
    }
    QTemporaryDir folder_;
};

BURIN_TEST(VolumeTest, QCoreApplication)

} // namespace burin::tst_volume

#include "tst_volume.moc"
