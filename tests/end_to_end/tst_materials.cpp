// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "program_run.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

namespace burin::tst_materials {

namespace {

const QByteArray card = "General:\n  Author: \"A. Miller\"\n  Name: \"Shop bronze\"\nModels:\n  Machinability:\n"
                        "    SurfaceSpeedCarbide: '180 m/min'\n    UnitCuttingForce: '780 N/mm^2'\n"
                        "    ChipThicknessExponent: 0.25\n";

} // namespace

/// From the list of available materials to a material of the user's own, of which a stock is made.
class MaterialsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { qputenv("XDG_DATA_HOME", folder_.path().toUtf8()); }
    void init() { QDir(folder_.filePath("burin")).removeRecursively(); }

    void allAreListed() {
        const ProgramRun run = runBurin({"materials", "list", "--json"});
        QCOMPARE(run.status, 0);
        const QJsonArray materials = run.json()["materials"].toArray();
        QVERIFY(materials.size() >= 17);
        for (const QJsonValue& each : materials) {
            QVERIFY(each.toObject()["specific_cutting_energy_j_mm3"].toDouble() > 0.0);
            QVERIFY(!each.toObject()["own"].toBool());
        }
        QVERIFY(runBurin({"materials", "list"}).output.contains("titanium-6al4v"));
    }

    void whatIsShownCanBeAdded() {
        const ProgramRun shown = runBurin({"materials", "show", "steel-1045"});
        QCOMPARE(shown.status, 0);
        QFile file(folder_.filePath("steel.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QVERIFY(file.write(QByteArray(shown.output).replace("steel-1045", "my-steel")) > 0);
        file.close();
        QCOMPARE(runBurin({"materials", "add", file.fileName()}).status, 0);
        QCOMPARE(runBurin({"materials", "add", file.fileName()}).status, 2); // the ID exists already
        QCOMPARE(runBurin({"materials", "show", "my-steel"}).status, 0);
        QCOMPARE(runBurin({"materials", "remove", "my-steel"}).status, 0);
        QVERIFY(runBurin({"materials", "show", "my-steel"}).status != 0);
    }

    void aCardOfFreeCadBecomesAStock() {
        QFile file(folder_.filePath("bronze.FCMat"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QVERIFY(file.write(card) == card.size());
        file.close();
        const ProgramRun added = runBurin({"materials", "add", file.fileName(), "--json"});
        QCOMPARE(added.status, 0);
        QCOMPARE(added.json()["id"].toString(), QString("shop-bronze"));
        QVERIFY(added.json()["notes"].toArray().size() >= 3); // values that the card does not state
        const ProgramRun embedded =
            runBurin({"embed", BURIN_FIXTURES "/models/cube.brep", "-o", folder_.filePath("cube.burin"), "--voxel", "1",
                      "--material", "shop-bronze", "--json"});
        QCOMPARE(embedded.status, 0);
        QCOMPARE(embedded.json()["material"].toString(), QString("shop-bronze"));
    }

    void whatIsShippedStays() {
        QCOMPARE(runBurin({"materials", "remove", "oak"}).status, 2);
        QCOMPARE(runBurin({"materials", "copy", "oak", "beech"}).status, 2);
        const ProgramRun copied = runBurin({"materials", "copy", "oak", "my-oak", "--name", "My oak"});
        QCOMPARE(copied.status, 0);
        QVERIFY(runBurin({"materials", "list"}).output.contains("My oak"));
        const ProgramRun unknown = runBurin({"materials", "show", "oka"});
        QCOMPARE(unknown.status, 2);
        QVERIFY(unknown.messages.contains("oak"));
    }

    void aCardWithoutForceIsRefused() {
        QFile file(folder_.filePath("bronze.FCMat"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QVERIFY(file.write(QByteArray(card).replace("UnitCuttingForce", "Colour").replace("ChipThickness", "Some")) >
                0);
        file.close();
        const ProgramRun refused = runBurin({"materials", "add", file.fileName()});
        QCOMPARE(refused.status, 3);
        QVERIFY(refused.messages.contains("specific_cutting_energy"));
        QVERIFY(!QFile::exists(folder_.filePath("burin/materials/shop-bronze.json")));
    }

private:
    QTemporaryDir folder_;
};

BURIN_TEST(MaterialsTest, QCoreApplication)

} // namespace burin::tst_materials

#include "tst_materials.moc"
