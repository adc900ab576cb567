// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"

#include "tests/places.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace burin::tst_calibrate {

namespace {

constexpr double energy = 0.85, ratio = 0.4, edge = 9.0; // J/mm³, 1, N/mm: used to make the records
const char* const columns = "material,force_x_n,force_y_n,force_z_n,axis_x,axis_y,axis_z,feed_x,feed_y,feed_z,"
                            "spindle_speed_1_min,diameter_mm,teeth,axial_depth_mm,radial_depth_mm,feed_mm_min\n";

/// Slots of 6 mm at 12,000 1/min as measured by a dynamometer, feed along X. Over half a turn the chip gives Ktc fz / 4
/// per tooth and mm across the feed and Krc fz / 4 against it, the edge Kte / pi and Kre / pi.
QByteArray dynamometer(const char* material) {
    QByteArray text = columns;
    const double errors[] = {0.02, -0.01, 0.015, -0.03, 0.01, -0.02, 0.025, -0.005};
    for (int i = 0; i < 8; ++i) {
        const double depth = 1.0 + i % 4, feed = 600.0 + 900.0 * (i / 4), perTooth = feed / 24'000.0;
        const double across = 2.0 * depth * (1000.0 * energy * perTooth / 4.0 + edge / 3.14159265358979);
        const double against = 2.0 * depth * (ratio * 1000.0 * energy * perTooth / 4.0 + 0.5 * edge / 3.14159265358979);
        text += QByteArray(material) + ',' + QByteArray::number(-against + errors[i], 'g', 12) + ',' +
                QByteArray::number(across + errors[7 - i], 'g', 12) + ",0,0,0,1,1,0,0,12000,6,2," +
                QByteArray::number(depth) + ",6," + QByteArray::number(feed) + '\n';
    }
    return text;
}

/// Slots of 6 mm at 12,000 1/min: forces on the tool by Ft = K MRR / v, with deviations of hundredths of a newton.
QByteArray records(const char* material) {
    QByteArray text = columns;
    const double errors[] = {0.02, -0.01, 0.015, -0.03, 0.01, -0.02, 0.025, -0.005};
    for (int i = 0; i < 8; ++i) {
        const double depth = 1.0 + i % 4, feed = 600.0 + 300.0 * (i / 4);
        const double force = 1000.0 * energy * depth * 6.0 * feed / 60.0 / (3.14159265358979 * 6.0 * 200.0);
        text += QByteArray(material) + ',' + QByteArray::number(-force + errors[i], 'g', 12) + ",0," +
                QByteArray::number(ratio * force + errors[7 - i], 'g', 12) + ",0,0,1,1,0,0,12000,6,2," +
                QByteArray::number(depth) + ",6," + QByteArray::number(feed) + '\n';
    }
    return text;
}

} // namespace

/// From measured forces to a material that is used when the next project is embedded.
class CalibrateTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { qputenv("XDG_DATA_HOME", folder_.path().toUtf8()); }
    void init() { QDir(folder_.filePath("burin")).removeRecursively(); }

    void aCalibratedMaterialIsThereForTheNextProject();
    void aDryRunWritesNothing();
    void nothingIsOverwrittenUnasked();
    void aNewNameNeedsAMaterialItIsLike();
    void aBrokenRowIsNamed();

private:
    QString write(const QByteArray& text) {
        const QString name = folder_.filePath("forces.csv");
        QFile file(name);
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) qFatal("no test file");
        return name;
    }
    QString library(const char* id) const { return folder_.filePath(QString("burin/materials/%1.json").arg(id)); }
    QTemporaryDir folder_;
};

void CalibrateTest::aCalibratedMaterialIsThereForTheNextProject() {
    const ProgramRun run = runBurin({"calibrate", write(records("shop-aluminium")), "--law", "constant", "--projection",
                                     "paper", "--like", "aluminium-6061", "--json"});
    QCOMPARE(run.status, 0);
    const QJsonObject answer = run.json();
    QCOMPARE(answer["confidence_level"].toDouble(), 0.95);
    const QJsonObject material = answer["materials"].toArray().at(0).toObject();
    QCOMPARE(material["records_used"].toInt(), 8);
    const QJsonObject k = material["specific_cutting_energy_j_mm3"].toObject();
    QVERIFY(k["low"].toDouble() <= energy && energy <= k["high"].toDouble());
    QVERIFY(k["high"].toDouble() - k["low"].toDouble() < 0.02);
    const QJsonObject kr = material["radial_force_ratio"].toObject();
    QVERIFY(kr["low"].toDouble() <= ratio && ratio <= kr["high"].toDouble());
    QCOMPARE(material["library_file"].toString(), library("shop-aluminium"));
    QCOMPARE(runBurin({"embed", BURIN_FIXTURES "/models/cube.brep", "-o", folder_.filePath("cube.burin"), "--voxel",
                       "1", "--material", "shop-aluminium"})
                 .status,
             0);
}

void CalibrateTest::aDryRunWritesNothing() {
    const ProgramRun run = runBurin({"calibrate", write(dynamometer("aluminium-6061")), "--dry-run"});
    QCOMPARE(run.status, 0);
    QVERIFY(run.output.contains("K "));
    QVERIFY(!QFile::exists(library("aluminium-6061")));
    // An unknown material does not need a similar one to be stated, as long as nothing is written.
    const ProgramRun unknown = runBurin({"calibrate", write(dynamometer("cheese")), "--dry-run", "--json"});
    QCOMPARE(unknown.status, 0);
    const QJsonObject material = unknown.json()["materials"].toArray().at(0).toObject();
    for (const auto& [key, truth] : {std::pair{"specific_cutting_energy_j_mm3", energy},
                                     {"radial_force_ratio", ratio},
                                     {"tangential_edge_force_n_mm", edge},
                                     {"radial_edge_force_n_mm", 0.5 * edge}}) {
        const QJsonObject found = material[QLatin1String(key)].toObject();
        QVERIFY2(found["low"].toDouble() <= truth && truth <= found["high"].toDouble(), key);
        QVERIFY2(std::abs(found["value"].toDouble() / truth - 1.0) < 0.02, key);
    }
}

void CalibrateTest::nothingIsOverwrittenUnasked() {
    const QString file = write(dynamometer("aluminium-6061"));
    const ProgramRun shipped = runBurin({"calibrate", file});
    QCOMPARE(shipped.status, 2);
    QVERIFY(shipped.messages.contains("--replace"));
    QVERIFY(!QFile::exists(library("aluminium-6061")));
    QCOMPARE(runBurin({"calibrate", file, "--replace"}).status, 0);
    QVERIFY(QFile::exists(library("aluminium-6061")));
    QCOMPARE(runBurin({"calibrate", file}).status, 2);
}

void CalibrateTest::aNewNameNeedsAMaterialItIsLike() {
    const ProgramRun run = runBurin({"calibrate", write(dynamometer("cheese"))});
    QCOMPARE(run.status, 2);
    QVERIFY(run.messages.contains("--like"));
    QVERIFY(runBurin({"calibrate", write(dynamometer("cheese")), "--material", "wax"}).status == 2);
}

void CalibrateTest::aBrokenRowIsNamed() {
    const ProgramRun run = runBurin({"calibrate", write(records("wax").replace("12000,6,2,3,", "12000,6,two,3,"))});
    QCOMPARE(run.status, 3);
    QVERIFY2(run.messages.contains("line 4, column teeth"), run.messages);
}

BURIN_TEST(CalibrateTest, QCoreApplication)

} // namespace burin::tst_calibrate

#include "tst_calibrate.moc"
