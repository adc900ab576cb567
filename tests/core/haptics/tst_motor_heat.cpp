// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/core/haptics/haptic_rig.h"
#include "tests/test_program.h"

#include <QtTest>

namespace burin::tst_motor_heat {

using namespace burin::test;

namespace {

constexpr double most = 0.6 * 4.0; // N: the device's share of desktopStylus' maximum

/// A hand that presses far into the part, so that the force is at its limit, with motors at a given temperature.
struct Press {
    explicit Press(double handleMass = 0.0) : rig(settings(handleMass)) {
        rig.begin({0.0, 0.0, 5.0});
        rig.moveTo({0.0, 0.0, floorHeight - 15.0}, 100.0);
        rig.rest(200);
        force = applied();
    }
    static HapticSettings settings(double handleMass) {
        HapticSettings settings = Rig::settings();
        settings.stylus.handleMass = {handleMass, "made up"};
        return settings;
    }
    glm::dvec3 applied() const { return rig.step.deviceWrench().force; }
    /// Runs ticks at a given heat; records the largest change of the force between two ticks.
    Sample holds(double heat, int ticks) {
        Sample sample;
        for (int i = 0; i < ticks; ++i) {
            StylusState state;
            state.pose.position = rig.hand;
            state.valid = true;
            state.motorHeat = heat;
            sample = rig.step.advance(state, period);
            largestChange = std::max(largestChange, glm::length(applied() - force));
            force = applied();
        }
        return sample;
    }

    Rig rig;
    glm::dvec3 force{0.0};
    double largestChange = 0.0; ///< N in a tick
};

} // namespace

/// Motors that report being hot are limited to half of the force, without a kick, and to all of it once they have
/// cooled.
class TestMotorHeat : public QObject {
    Q_OBJECT
private slots:
    void hotMotorsAreAskedForHalf() {
        Press press;
        QVERIFY(std::abs(glm::length(press.force) - most) < 1e-9);
        QVERIFY(!(press.holds(0.8, 100).flags & sampleMotorsHot));
        QVERIFY(std::abs(glm::length(press.force) - most) < 1e-9);
        QVERIFY(press.holds(0.81, 1).flags & sampleMotorsHot); // reported at once
        const Sample later = press.holds(0.81, 2100);
        QVERIFY(std::abs(glm::length(press.force) - 0.5 * most) < 1e-9);
        QVERIFY(later.flags & sampleMotorsHot);
        QVERIFY(later.flags & sampleForceSaturated);
        QVERIFY2(press.largestChange < 0.02, "N a tick: what a hand is held to notice");
        QVERIFY(glm::length(later.force) <= 0.5 * most + 1e-9);
    }

    /// Between 0.75 and 0.8 nothing changes, so that a sensor's noise does not make the force oscillate.
    void theyAreAskedForAllOfItWhenTheyHaveCooled() {
        Press press;
        press.holds(0.9, 3000);
        QVERIFY(std::abs(glm::length(press.force) - 0.5 * most) < 1e-9);
        press.holds(0.77, 1000);
        QVERIFY(std::abs(glm::length(press.force) - 0.5 * most) < 1e-9);
        const Sample cool = press.holds(0.7, 2100);
        QVERIFY(std::abs(glm::length(press.force) - most) < 1e-9);
        QVERIFY(!(cool.flags & sampleMotorsHot));
        QVERIFY(press.largestChange < 0.02);
    }

    /// The force that carries the handle is part of the force sent, and is reduced as well.
    void allThatIsSentIsHalf() {
        constexpr double mass = 0.1; // kg
        Press press(mass);
        // The contact pushes up, out of the floor, and the lift carries the handle: their sum is the largest permitted
        // force.
        QVERIFY(std::abs(press.force.z - most) < 1e-9);
        press.holds(0.95, 3000);
        QVERIFY(std::abs(press.force.z - 0.5 * most) < 1e-9);
        press.rig.moveTo({0.0, 0.0, 5.0}, 100.0);
        press.rig.hand = {0.0, 0.0, 5.0};
        press.holds(0.95, 600);
        const glm::dvec3 lift{0.0, 0.0, std::min(mass * 9.80665, 0.25 * most)};
        QVERIFY(glm::length(press.force - lift) < 1e-6);
    }

    void heatThatIsNoNumberSaysNothing() {
        Press press;
        for (const double heat : {std::nan(""), -HUGE_VAL, -1.0}) {
            QVERIFY(!(press.holds(heat, 50).flags & sampleMotorsHot));
            QVERIFY(std::abs(glm::length(press.force) - most) < 1e-9);
        }
        QVERIFY(press.holds(HUGE_VAL, 1).flags & sampleMotorsHot);
    }
};

BURIN_TEST(TestMotorHeat, NoApplication)

} // namespace burin::tst_motor_heat

#include "tst_motor_heat.moc"
