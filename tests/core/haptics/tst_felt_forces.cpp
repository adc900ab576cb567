// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/core/haptics/haptic_rig.h"
#include "tests/oracles/random_number.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_felt_forces {

using namespace burin::test;

/// The share of the forces of cutting, sliding and weight that reaches the hand.
class FeltForcesTest : public QObject {
    Q_OBJECT
private slots:
    void cuttingIsFeltAgainstTheMotionWithinItsShare() {
        HapticSettings settings = Rig::settings();
        Rig rig(settings);
        rig.begin({-30, 0, -3});
        rig.moveTo({-10, 0, -3}, 30.0);
        double rendered = 0.0, unscaled = 0.0;
        int ticks = 0;
        rig.onTick = [&](const Sample& sample) {
            rendered -= sample.force.x;
            unscaled -= sample.cuttingForce.x;
            ++ticks;
            QVERIFY(glm::length(sample.force) <= 0.6 * 4.0 + 1e-9);
        };
        rig.moveTo({10, 0, -3}, 30.0);
        // Slot of a ball, 3 mm deep: half a disc of radius 3 moves through the stock. All of it is ahead of the tool,
        // so the radial part, 0.3 of the tangential one, points back as well. It is the reference cut of its only
        // material: 0.6 of the permitted 2.4 N.
        const double area = 0.5 * pi * 9.0;
        const double expected = 1.3 * 1000.0 * 0.7 * area * 30.0 / 1000.0;
        QVERIFY2(std::abs(unscaled / ticks - expected) <= 0.05 * expected,
                 qPrintable(QString::number(unscaled / ticks)));
        const double felt = 1.3 * 0.6 * 2.4;
        QVERIFY2(std::abs(rendered / ticks - felt) <= 0.05 * felt, qPrintable(QString::number(rendered / ticks)));
        // At rest the force holds as dry friction does, and neither pushes the hand nor vanishes.
        rig.onTick = [](const Sample&) {};
        const glm::dvec3 held = rig.rest(50).force;
        QVERIFY(glm::length(rig.rest(300).force - held) < 1e-3);
        QVERIFY(glm::length(held) <= felt * 1.02);
        // Back in the slot there is nothing to cut, and outside of it there is no force at all.
        rig.moveTo({4, 0, -3}, 30.0);
        QVERIFY(glm::length(rig.rest(1).force) < 0.1);
        rig.moveTo({4, 0, 3}, 30.0);
        QVERIFY(glm::length(rig.rest(1).force) < 0.01);
    }

    /// Half immersed, the wall pushes the tool away from it; but a lateral force on a tool at rest would drive the
    /// hand, so it vanishes when the motion does.
    void aWallPushesAMovingToolAside() {
        Rig rig;
        rig.begin({-30, 0, -3});
        rig.moveTo({30, 0, -3}, 60.0);
        rig.moveTo({30, 0, 5}, 60.0);
        rig.moveTo({-30, 3, 5}, 200.0);
        rig.moveTo({-30, 3, -3}, 60.0);
        rig.moveTo({-10, 3, -3}, 30.0); // stock on the left, at y from 3 to 6
        double along = 0.0, aside = 0.0;
        int ticks = 0;
        rig.onTick = [&](const Sample& sample) {
            along -= sample.force.x;
            aside -= sample.force.y;
            ++ticks;
        };
        rig.moveTo({5, 3, -3}, 30.0);
        // The centroid, weighted by flux, of the quarter cylinder that is in the stock is 0.785 radius ahead and 0.5 to
        // the left: with Kr = 0.3 that is 0.16 sideways compared with 1 + 0.25 against the motion. That of a ball is a
        // little nearer to its axis.
        QVERIFY2(aside > 0.08 * along && aside < 0.16 * along, qPrintable(QString::number(aside / along)));
        rig.onTick = [](const Sample&) {};
        const Sample rest = rig.rest(300);
        QVERIFY(std::abs(rest.force.y) < 0.02);
        QVERIFY(-rest.force.x > 0.8 * along / ticks);
    }

    /// On material that it does not cut the tool slides with Coulomb friction: friction coefficient times load, against
    /// the motion, and at rest at most that.
    void slidingOnThePartRubs() {
        HapticSettings settings = Rig::settings();
        settings.felt.friction = 0.2;
        Rig rig(settings, ballTool(), stockOnPart(0, false));
        rig.begin({-10, 0, 3});
        rig.moveTo({-10, 0, floorHeight - 3.0}, 50.0);
        rig.moveTo({0, 0, floorHeight - 3.0}, 30.0);
        const double load = 0.32 * 3.0;
        rig.onTick = [&](const Sample& sample) {
            QVERIFY(std::abs(sample.force.x + 0.2 * load) < 0.01 * load);
            QVERIFY(std::abs(sample.force.z - load) < 0.01 * load);
        };
        rig.moveTo({5, 0, floorHeight - 3.0}, 30.0);
        rig.rest(200);
        rig.onTick = [](const Sample&) {};
        rig.moveTo({5, 0, floorHeight + 1.0}, 50.0);
        QVERIFY(glm::length(rig.rest(20).force) < 1e-6);
    }

    /// A mass of 0.05 kg on the hand: 0.49 N up, in the device's frame however it is turned, and not included in the
    /// record.
    void theMotorsCarryTheHandle_data() {
        QTest::addColumn<double>("mass");
        QTest::addColumn<bool>("carriesItself");
        QTest::addColumn<double>("lift");
        QTest::newRow("a stylus") << 0.05 << false << 0.05 * 9.80665;
        QTest::newRow("a device with a counterweight") << 0.05 << true << 0.0;
        QTest::newRow("one that is too heavy for its motors") << 5.0 << false << 0.5 * 0.6 * 4.0;
    }
    void theMotorsCarryTheHandle() {
        QFETCH(double, mass);
        QFETCH(bool, carriesItself);
        QFETCH(double, lift);
        HapticSettings settings = Rig::settings();
        settings.stylus.handleMass = {mass, "made up"};
        settings.stylus.carriesHandle = carriesItself;
        settings.mapping.rotation = glm::angleAxis(1.0, glm::dvec3(1, 0, 0));
        Rig rig(settings, ballTool(), stockOnPart(0, false));
        rig.begin(settings.mapping.toDevice({0, 0, 3}));
        // The force increases in steps, so that there is no kick after a tick without force.
        double before = 0.0;
        rig.onTick = [&](const Sample&) {
            const double sent = glm::length(rig.step.deviceWrench().force);
            QVERIFY(sent - before <= 0.05 + 1e-9);
            before = sent;
        };
        before = glm::length(rig.step.deviceWrench().force);
        const Sample free = rig.rest(30);
        QVERIFY(glm::length(free.force) < 1e-9);
        QVERIFY(glm::length(rig.step.deviceWrench().force - glm::dvec3(0, 0, lift)) < 1e-9);
        // Pressed hard, lift and contact force together stay within the permitted force, and both are present.
        rig.onTick = [&](const Sample& sample) {
            const glm::dvec3 sent = rig.step.deviceWrench().force;
            QVERIFY(glm::length(sent) <= 0.6 * 4.0 + 1e-9);
            QVERIFY(glm::length(sent - glm::dvec3(0, 0, lift) - settings.mapping.directionToDevice(sample.force)) <
                    1e-9);
        };
        rig.moveTo(settings.mapping.toDevice({0, 0, floorHeight - 12.0}), 50.0);
        const Sample pressed = rig.rest(100);
        QVERIFY(pressed.flags & sampleForceSaturated);
        QVERIFY(std::abs(glm::length(pressed.force) - (0.6 * 4.0 - lift)) < 1e-6);
        // With an invalid reading there is no force, and no lift either.
        StylusState broken;
        rig.step.advance(broken, period);
        QCOMPARE(rig.step.deviceWrench().force, glm::dvec3(0.0));
    }

    /// The part has priority: the cutting force is reduced in its favour, and the record says so.
    void theCuttingForceGivesWayToWhatHoldsTheTool() {
        QVERIFY(rc::check([] {
            const glm::dvec3 held(randomNumber(-3, 3), randomNumber(-3, 3), randomNumber(-3, 3));
            const glm::dvec3 cutting(randomNumber(-3, 3), randomNumber(-3, 3), randomNumber(-3, 3));
            const glm::dvec3 room = besideHeld(held, cutting, 2.4);
            const double share = glm::dot(room, cutting) / std::max(1e-12, glm::dot(cutting, cutting));
            RC_ASSERT(share >= 0.0 && share <= 1.0 + 1e-12);
            RC_ASSERT(glm::length(room - share * cutting) < 1e-9); // its direction is kept
            const double both = glm::length(held + room);
            if (glm::length(held + cutting) <= 2.4) RC_ASSERT(share > 1.0 - 1e-9);
            if (glm::length(held) <= 2.4) RC_ASSERT(both <= 2.4 + 1e-9);
            // No larger share stays within the maximum; where no share does, none comes nearer.
            for (double other = 0.0; other <= 1.0; other += 0.05) {
                const double then = glm::length(held + other * cutting);
                if (then <= 2.4) RC_ASSERT(share >= other - 1e-9);
                if (both > 2.4 + 1e-9) RC_ASSERT(then >= both - 1e-9);
            }
        }));
    }
};

BURIN_TEST(FeltForcesTest, NoApplication)

} // namespace burin::tst_felt_forces

#include "tst_felt_forces.moc"
