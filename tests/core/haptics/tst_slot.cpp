// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/slot_scene.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_slot {

using namespace burin::test;

/// Forces that a hand feels in a slot of constant depth, compared with closed formulas.
class SlotTest : public QObject {
    Q_OBJECT
private slots:
    void theForceIsKTimesTheArea_data() {
        QTest::addColumn<int>("cutter");
        QTest::addColumn<double>("speed");
        QTest::addColumn<double>("heading");
        QTest::addColumn<double>("encoder");
        QTest::addColumn<double>("firstEnergy");
        const auto row = [](const char* name, CutterType cutter, double speed, double heading, double encoder,
                            double firstEnergy) {
            QTest::newRow(name) << static_cast<int>(cutter) << speed << heading << encoder << firstEnergy;
        };
        row("flat, along the lines", CutterType::flat, 20.0, 0.0, 0.0, 1.0);
        row("flat, slanted, coarse encoder", CutterType::flat, 20.0, 0.6, 0.055, 1.0);
        row("flat, into harder material", CutterType::flat, 20.0, 0.6, 0.02, 0.4);
        row("flat, into softer material", CutterType::flat, 20.0, 0.0, 0.055, 2.0);
        row("ball, slow", CutterType::ball, 5.0, 0.0, 0.02, 1.0);
        row("ball, into harder material", CutterType::ball, 20.0, 0.6, 0.055, 0.4);
        row("ball, fast, into softer material", CutterType::ball, 50.0, 0.0, 0.0, 2.5);
        row("bull nose, slanted", CutterType::bullNose, 20.0, 0.6, 0.02, 1.0);
        row("bull nose, into harder material", CutterType::bullNose, 20.0, 0.0, 0.055, 0.5);
    }
    void theForceIsKTimesTheArea() {
        QFETCH(int, cutter);
        QFETCH(double, speed);
        QFETCH(double, heading);
        QFETCH(double, encoder);
        QFETCH(double, firstEnergy);
        SlotCase of;
        of.cutter = static_cast<CutterType>(cutter);
        of.speed = speed;
        of.heading = heading;
        of.mechanism.encoder = encoder;
        of.firstEnergy = firstEnergy;
        const SlotFigures figures = SlotScene(of).mill();
        const QByteArray said = "error " + QByteArray::number(figures.forceError) + ", noise " +
                                QByteArray::number(figures.noise) + ", creep " + QByteArray::number(figures.creep) +
                                ", ticks " + QByteArray::number(figures.ticksToChange);
        QVERIFY2(figures.forceError <= 0.05, said);
        QVERIFY2(figures.noise <= 0.005, said);
        QVERIFY2(figures.creep <= 1.0, said);
        if (firstEnergy != 1.0) QVERIFY2(figures.ticksToChange >= 0 && figures.ticksToChange <= 2, said);
    }

    /// A light and a firm hand, a stiff device, and a force with a delay of one tick give the same results.
    void handsAndDevicesMayDiffer_data() {
        QTest::addColumn<double>("mass");
        QTest::addColumn<double>("damping");
        QTest::addColumn<double>("gripStiffness");
        QTest::addColumn<double>("stiffness");
        QTest::addColumn<int>("delay");
        QTest::newRow("light hand") << lightGrip.mass << lightGrip.damping << lightGrip.stiffness << 320.0 << 0;
        QTest::newRow("firm hand, a tick late")
            << firmGrip.mass << firmGrip.damping << firmGrip.stiffness << 320.0 << 1;
        QTest::newRow("stiff device") << middleGrip.mass << middleGrip.damping << middleGrip.stiffness << 1000.0 << 0;
    }
    void handsAndDevicesMayDiffer() {
        QFETCH(double, mass);
        QFETCH(double, damping);
        QFETCH(double, gripStiffness);
        QFETCH(double, stiffness);
        QFETCH(int, delay);
        SlotCase of;
        of.grip = {mass, damping, gripStiffness};
        of.stiffness = stiffness;
        of.mechanism.encoder = 0.0;
        of.mechanism.delay = static_cast<std::size_t>(delay);
        const SlotFigures figures = SlotScene(of).mill();
        QVERIFY2(figures.forceError <= 0.05, qPrintable(QString::number(figures.forceError)));
        QVERIFY2(figures.noise <= 0.005, qPrintable(QString::number(figures.noise)));
        QVERIFY2(figures.creep <= 1.0, qPrintable(QString::number(figures.creep)));
    }
};

BURIN_TEST(SlotTest, NoApplication)

} // namespace burin::tst_slot

#include "tst_slot.moc"
