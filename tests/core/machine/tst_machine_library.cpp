// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/resource_folder.h"
#include "core/machine/machine_library.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace burin;

class MachineLibraryTest : public QObject {
    Q_OBJECT

    QTemporaryDir userData_;

private slots:
    void initTestCase() { qputenv("XDG_DATA_HOME", userData_.path().toUtf8()); }

    void everyShippedMachineLoads() {
        QVERIFY(!machineIds().empty());
        for (const std::string& id : machineIds()) {
            const Result<MachineProfile> machine = loadMachine(id);
            QVERIFY2(machine.hasValue(), machine ? "" : (id + ": " + machine.error().place).c_str());
            QCOMPARE(machine->id, id);
            QVERIFY(machine->rapidFeed >= machine->maximumFeed);
            QVERIFY(machine->toolChangeHeight < machine->travel.z);
        }
    }

    void theExampleMillTakesTheSamplePart() {
        const Result<MachineProfile> mill = loadMachine("linuxcnc-mill");
        QVERIFY(mill.hasValue());
        QVERIFY(mill->travel.x >= 150.0 && mill->travel.y >= 100.0 && mill->travel.z >= 150.0);
        QCOMPARE(mill->maximumSpindleSpeed, 24000.0);
        QCOMPARE(mill->maximumLineLength, 255);
        QVERIFY(mill->source.find("example") != std::string::npos);
    }

    void anUnknownMachineNamesThoseThereAre() {
        const Result<MachineProfile> machine = loadMachine("dmu-50");
        QVERIFY(!machine.hasValue());
        QVERIFY(machine.error().code == ErrorCode::nameUnknown);
        QCOMPARE(machine.error().subject, std::string("machine"));
        QVERIFY(machine.error().detail.find("linuxcnc-mill") != std::string::npos);
    }

    void aBrokenFileNamesItsKey_data() {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("key");
        QTest::newRow("two axes") << "[500, 400, 250]"
                                  << "[500, 400]"
                                  << "travel_mm";
        QTest::newRow("an axis of text") << "[500, 400, 250]"
                                         << R"([500, "400", 250])"
                                         << "travel_mm[1]";
        QTest::newRow("negative feed") << R"("maximum_feed_mm_per_min": 4000)"
                                       << R"("maximum_feed_mm_per_min": -1)"
                                       << "maximum_feed_mm_per_min";
        QTest::newRow("spindle upside down") << R"("minimum_spindle_speed_rpm": 3000)"
                                             << R"("minimum_spindle_speed_rpm": 30000)"
                                             << "minimum_spindle_speed_rpm";
        QTest::newRow("missing") << R"("coordinate_decimals": 3,)"
                                 << ""
                                 << "coordinate_decimals";
        QTest::newRow("unknown") << R"("coordinate_decimals")"
                                 << R"("axes": 5, "coordinate_decimals")"
                                 << "axes";
    }
    void aBrokenFileNamesItsKey() {
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(QString, key);
        QString text = QString::fromStdString(findResource(machineResource, "linuxcnc-mill")->text);
        QVERIFY(text.contains(from));
        const Result<MachineProfile> machine = machineFromJson(text.replace(from, to).toStdString(), "bad.json");
        QVERIFY(!machine.hasValue());
        QVERIFY(machine.error().code == ErrorCode::resourceInvalid);
        QCOMPARE(QString::fromStdString(machine.error().place), key);
    }
};

QTEST_APPLESS_MAIN(MachineLibraryTest)
#include "tst_machine_library.moc"
