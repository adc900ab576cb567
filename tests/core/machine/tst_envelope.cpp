// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/machine/envelope.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_envelope {

namespace {

MachineProfile mill() {
    MachineProfile machine;
    machine.travel = {500.0, 400.0, 250.0};
    machine.toolChangeHeight = 60.0;
    return machine;
}

const glm::dvec3 zero(15.0, -7.0, 30.0); // of the program, setup frame

} // namespace

class TestEnvelope : public QObject {
    Q_OBJECT
private slots:
    void programZeroStandsWhereItIsSaidTo() {
        const Box travel = travelEnvelope(mill(), {true, glm::dvec3(100.0, 50.0, 200.0)}, zero, zero).tips;
        QCOMPARE(travel.low, glm::dvec3(-85.0, -57.0, -170.0));
        QCOMPARE(travel.high, travel.low + glm::dvec3(500.0, 400.0, 250.0));
    }
    /// In the middle, and no lower than the clearance height above it that the machine profile requires.
    void whereNothingIsSaidItStandsInTheMiddle() {
        const Box travel = travelEnvelope(mill(), {}, zero, zero).tips;
        QCOMPARE(travel.centre().x, zero.x);
        QCOMPARE(travel.centre().y, zero.y);
        QCOMPARE(travel.high.z, zero.z + 60.0);
        QCOMPARE(travel.size(), glm::dvec3(500.0, 400.0, 250.0));
    }
    /// A zero at another point of the stock, to the side or below, does not move the stock on its table.
    void aZeroOnACornerLeavesTheStockWhereItIs() {
        const Box middle = travelEnvelope(mill(), {}, zero, zero).tips;
        const Box corner = travelEnvelope(mill(), {}, zero - glm::dvec3(20.0, 30.0, 10.0), zero).tips;
        QCOMPARE(corner.low, middle.low);
        QCOMPARE(corner.high, middle.high);
    }
    void switchedOffItLimitsNothing() {
        const Envelope none = travelEnvelope(mill(), {false, glm::dvec3(0.0)}, zero, zero);
        QVERIFY(none.tips.empty() && none.tools.empty());
    }
};

BURIN_TEST(TestEnvelope, NoApplication)

} // namespace burin::tst_envelope

#include "tst_envelope.moc"
