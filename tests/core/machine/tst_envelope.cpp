// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/machine/envelope.h"

#include <QtTest>

using namespace burin;

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
        const Box travel = travelEnvelope(mill(), {true, glm::dvec3(100.0, 50.0, 200.0)}, zero).tips;
        QCOMPARE(travel.low, glm::dvec3(-85.0, -57.0, -170.0));
        QCOMPARE(travel.high, travel.low + glm::dvec3(500.0, 400.0, 250.0));
    }
    /// In the middle, and no lower than the machine's promise of a free height above it asks for.
    void whereNothingIsSaidItStandsInTheMiddle() {
        const Box travel = travelEnvelope(mill(), {}, zero).tips;
        QCOMPARE(travel.centre().x, zero.x);
        QCOMPARE(travel.centre().y, zero.y);
        QCOMPARE(travel.high.z, zero.z + 60.0);
        QCOMPARE(travel.size(), glm::dvec3(500.0, 400.0, 250.0));
    }
    void switchedOffItLimitsNothing() {
        const Envelope none = travelEnvelope(mill(), {false, glm::dvec3(0.0)}, zero);
        QVERIFY(none.tips.empty() && none.tools.empty());
    }
};

QTEST_APPLESS_MAIN(TestEnvelope)
#include "tst_envelope.moc"
