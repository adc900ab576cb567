// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/boundary/pose_vector.h"
#include "core/haptics/force/turn_coupling.h"
#include "tests/core/device/desktop_stylus.h"
#include "tests/core/haptics/haptic_rig.h"
#include "tests/oracles/simulated_handle.h"
#include "tests/test_program.h"

#include <QtTest>

#include <random>

namespace burin::tst_turn_coupling {

using namespace burin::test;

namespace {

HapticSettings settingsOf(double stiffness, double step = 0.0, double torque = 1e6) {
    HapticSettings settings;
    settings.couplingShare = 1.0;
    settings.stylus = desktopStylus();
    settings.stylus.actuated = {3, 3};
    settings.stylus.maximumTorque = {torque, "made up"};
    settings.stylus.maximumTurningStiffness = {stiffness, "made up"};
    settings.stylus.rotationStep = {step, "made up"};
    return settings;
}

glm::dquat aboutY(double angle) {
    return glm::angleAxis(angle, glm::dvec3(0, 1, 0));
}

/// A pen of 0.1 kg in a hand of given impedance, as a handle whose millimetres are radians: kg mm² for kg, N·mm for N
/// (the grip's stiffness in mN·m, because the handle divides by a thousand).
constexpr SimulatedGrip lightWrist{100.0, 5e3, 2e5}, firmWrist{600.0, 2e4, 2e6};

/// Energy, mJ, that the hand gains by turning into a stop, which begins at an angle of 0, and out again, the worst of
/// ten times. @param coupling nullptr: only the spring
double energyOfTurn(TurnCoupling* coupling, double stiffness, const SimulatedGrip& grip, double step) {
    constexpr int cycle = 1000, cycles = 10; // ticks
    constexpr double reach = 0.3;            // rad
    SimulatedHandle handle(grip, {.mass = 80.0, .damping = 200.0, .encoder = step}, {0, reach, 0});
    double worst = -1.0, before = 0.0;
    for (int tick = 0; tick < cycle * cycles; ++tick) {
        const double angle = handle.reading().y;
        const glm::dvec3 behind(0.0, angle < 0.0 ? -angle : 0.0, 0.0);
        glm::dvec3 torque = stiffness * behind;
        if (coupling != nullptr) {
            torque = coupling->torque(behind, aboutY(angle), period);
            coupling->sent(torque);
        }
        handle.hold(torque, {0, reach * std::cos(2.0 * pi * tick / cycle), 0}, glm::dvec3(0.0), period);
        if ((tick + 1) % cycle != 0) continue;
        worst = std::max(worst, 1e3 * (handle.energy() - before));
        before = handle.energy();
    }
    return worst;
}

} // namespace

class TestTurnCoupling : public QObject {
    Q_OBJECT
private slots:
    void theTurnBetweenTwoRotationsIsTheOneThatWasMade() {
        std::mt19937 engine(5);
        std::uniform_real_distribution<double> number(-1.0, 1.0);
        for (int i = 0; i < 1000; ++i) {
            const glm::dvec3 turn = 1.8 * glm::dvec3(number(engine), number(engine), number(engine));
            if (glm::length(turn) > 3.1 || glm::length(turn) < 1e-3) continue;
            const glm::dquat from = glm::normalize(glm::dquat(number(engine), number(engine), number(engine), 0.4));
            const glm::dquat to = glm::angleAxis(glm::length(turn), glm::normalize(turn)) * from;
            QVERIFY(glm::length(turnBetween(from, to) - turn) < 1e-9);
            QVERIFY(glm::length(turnBetween(from, -to) - turn) < 1e-9);
        }
        QCOMPARE(turnBetween(aboutY(0.3), aboutY(0.3)), glm::dvec3(0.0));
    }

    void aTorqueNeverJumps() {
        TurnCoupling coupling(settingsOf(16.0, 0.0, 180.0));
        const double most = coupling.stiffness() * 5.0 * period;
        glm::dvec3 last(0.0);
        std::mt19937 engine(3);
        std::uniform_real_distribution<double> number(-3.0, 3.0);
        for (int tick = 0; tick < 5000; ++tick) {
            const glm::dvec3 behind(number(engine), number(engine), number(engine));
            const glm::dvec3 torque = coupling.torque(behind, aboutY(0.1 * number(engine)), period);
            coupling.sent(torque);
            QVERIFY(glm::length(torque) <= coupling.maximum() * (1.0 + 1e-12));
            QVERIFY(glm::length(torque - last) <= most * (1.0 + 1e-9));
            last = torque;
        }
    }

    void turningIntoAStopGivesTheHandNoEnergy_data() {
        QTest::addColumn<double>("stiffness"); // N·mm/rad
        QTest::addColumn<double>("step");      // rad
        for (const double stiffness : {20.0, 500.0, 2000.0})
            for (const double step : {0.0, 0.0005, 0.002})
                QTest::addRow("%g N mm/rad, steps of %g rad", stiffness, step) << stiffness << step;
    }
    void turningIntoAStopGivesTheHandNoEnergy() {
        QFETCH(double, stiffness);
        QFETCH(double, step);
        for (const SimulatedGrip& grip : {lightWrist, firmWrist}) {
            TurnCoupling coupling(settingsOf(stiffness, step));
            const double energy = energyOfTurn(&coupling, stiffness, grip, step);
            QVERIFY2(energy <= 0.02, qPrintable(QString::number(energy)));
        }
    }
    void theSpringAloneWouldGiveIt() { QVERIFY(energyOfTurn(nullptr, 2000.0, firmWrist, 0.002) > 0.1); }
};

BURIN_TEST(TestTurnCoupling, NoApplication)

} // namespace burin::tst_turn_coupling

#include "tst_turn_coupling.moc"
