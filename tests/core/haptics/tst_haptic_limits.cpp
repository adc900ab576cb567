// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/core/haptics/hostile_rig.h"
#include "tests/oracles/allocation_count.h"
#include "tests/test_program.h"

#include <QtTest>

#include <new>

namespace burin::tst_haptic_limits {

using namespace burin::test;

namespace {

constexpr int contacts = 10;

/// Energy that a handle receives from the loop while a light hand drives it into the floor and out again, J; device and
/// hand are a mass on a spring and a damper, the position is read in encoder steps.
double energyGivenToTheHand(double maximumDamping, double stiffness) {
    HapticSettings settings = Rig::settings();
    settings.stylus.maximumStiffness.value = stiffness;
    settings.stylus.maximumDamping.value = maximumDamping;
    settings.stylus.maximumForce.value = 100.0;
    Rig rig(settings, ballTool(), stockOnPart(0, false));
    constexpr double mass = 0.1, handStiffness = 100.0, handDamping = 0.5, encoder = 0.055; // kg, N/m, N·s/m, mm
    constexpr int substeps = 20;
    double position = floorHeight + 2.0, velocity = 0.0, energy = 0.0; // mm, mm/s
    rig.begin({0, 0, position});
    for (int tick = 0; tick < contacts * 1000; ++tick) {
        rig.feed({0, 0, std::round(position / encoder) * encoder});
        const double force = rig.step.deviceWrench().force.z;
        const double request = floorHeight + 2.0 * std::cos(2.0 * pi * tick * period); // one contact a second
        const double before = position;
        for (int i = 0; i < substeps; ++i) {
            const double hand = (handStiffness * (request - position) - handDamping * velocity) / 1000.0; // N
            velocity += (force + hand) / mass * 1000.0 * period / substeps;
            position += velocity * period / substeps;
        }
        energy += force * (position - before) / 1000.0;
    }
    return energy;
}

} // namespace

class TestHapticLimits : public QObject {
    Q_OBJECT
private slots:
    void hostileTicksNeverBreakTheLimits() {
        HapticSettings settings = Rig::settings();
        settings.rampSeconds = 0.05;
        settings.felt.gain = 100.0;
        Rig rig(settings, ballTool(5.0, 12.0));
        const double largest = settings.forceShare * settings.stylus.maximumForce.value;
        // The ramp's own slope is added to the slew limit: at most 1.5 times its share per tick.
        const double slope = 1.5 * period / settings.rampSeconds * largest;
        const double rise = std::max(0.15, 320.0 * 0.5 * period) + slope, fall = 3.0 * rise;
        HostileStylus hostile(strayingInTheStock(20260725));
        SeededRandom random(5);
        glm::dvec3 before(0.0);
        int bad = 0, pressed = 0;
        for (int i = 0; i < 200'000; ++i) {
            const HostileStylus::Tick tick = hostile.next();
            if (random.below(1000) == 0) rig.step.setAllowance(random.between(-1.0, 1.0));
            const Sample sample = rig.step.advance(tick.state, tick.period);
            const glm::dvec3 force = rig.step.deviceWrench().force;
            hostile.write(rig.step.deviceWrench());
            QVERIFY(isFinite(force) && isFinite(sample.proxy.tip) && isFinite(sample.cuttingForce));
            QVERIFY(isFinite(sample.device.position) && std::isfinite(sample.time));
            QVERIFY(glm::length(force) <= largest + 1e-12);
            if (HostileStylus::mustBeStill(tick.event)) {
                QCOMPARE(force, glm::dvec3(0.0));
                QVERIFY(sample.flags & sampleForcesOff);
                ++bad;
            } else if (glm::length(force) > 0.0) {
                QVERIFY(glm::length(force - before) <= fall + 1e-12);
                QVERIFY(glm::length(force) - glm::length(before) <= rise + 1e-12);
                ++pressed;
            }
            before = force;
        }
        QVERIFY(bad > 1000);
        QVERIFY(pressed > 15'000);
        QCOMPARE(rig.volume.amounts().units[2], stockOnPart().amounts().units[2]);
    }

    void aBadSampleEndsTheForceAtOnceAndItFadesInAgain() {
        HapticSettings settings = Rig::settings();
        settings.rampSeconds = 0.5;
        Rig rig(settings, ballTool(), stockOnPart(0, false));
        rig.begin({0, 0, 3});
        rig.moveTo({0, 0, floorHeight - 3.0}, 50.0);
        const double full = rig.rest(1000).force.z;
        QVERIFY(full > 0.9);
        QCOMPARE(rig.step.advance(StylusState{}, period).force, glm::dvec3(0.0));
        double before = 0.0;
        for (int tick = 0; tick < 490; ++tick) {
            const Sample sample = rig.rest(1);
            QVERIFY(sample.flags & sampleForcesOff);
            QVERIFY(sample.force.z >= before && sample.force.z - before < 0.01);
            before = sample.force.z;
        }
        QVERIFY(std::abs(rig.rest(200).force.z - full) < 1e-6);
    }

    void aLateTickIsForceFreeAndAStallFadesInAgain() {
        HapticSettings settings = Rig::settings();
        settings.rampSeconds = 0.5;
        Rig rig(settings, ballTool(), stockOnPart(0, false));
        rig.begin({0, 0, 3});
        rig.moveTo({0, 0, floorHeight - 3.0}, 50.0);
        rig.rest(1000);
        StylusState state;
        state.pose.position = rig.hand;
        state.valid = true;
        QCOMPARE(rig.step.advance(state, 0.005).force, glm::dvec3(0.0));
        QVERIFY(rig.rest(20).force.z > 0.9);
        QCOMPARE(rig.step.advance(state, 0.02).force, glm::dvec3(0.0));
        QVERIFY(rig.rest(20).force.z < 0.1);
    }

    void aStylusWithoutMotorsGetsNoForce() {
        HapticSettings settings = Rig::settings();
        settings.stylus = StylusDescription{};
        Rig rig(settings);
        rig.onTick = [](const Sample& sample) {
            QCOMPARE(sample.force, glm::dvec3(0.0));
            QVERIFY(!(sample.flags & sampleForceSaturated));
        };
        rig.begin({0, 0, 3});
        const Sample sample = rig.moveTo({0, 0, floorHeight - 3.0}, 50.0);
        QVERIFY(std::abs(sample.proxy.tip.z - floorHeight) < 1e-3);
    }

    void aTickAllocatesNothing() {
        Rig rig(Rig::settings(), ballTool(5.0, 12.0));
        rig.begin({-12, 0, 2});
        const std::size_t before = allocationCount.load();
        rig.moveTo({-12, 0, -4}, 30.0);
        rig.moveTo({12, 3, -4}, 40.0);
        rig.moveTo({10, -3, -14}, 40.0);
        rig.step.setAllowance(0.3);
        rig.moveTo({-12, -3, -14}, 60.0);
        rig.step.advance(StylusState{}, period);
        rig.moveTo({-12, -3, 5}, 60.0);
        QCOMPARE(allocationCount.load(), before);
        ::operator delete(::operator new(1)); // proves that the counter counts
        QVERIFY(allocationCount.load() > before);
    }

    void contactGivesTheHandNoEnergy_data() {
        QTest::addColumn<double>("stiffness");
        QTest::addColumn<double>("damping");
        QTest::newRow("desktop device") << 400.0 << 4.0;
        QTest::newRow("stiff device") << 1500.0 << 4.0;
        QTest::newRow("device that claims a strong damper") << 1500.0 << 30.0;
        QTest::newRow("ten times stiffer than its damping allows") << 4000.0 << 8.0;
    }
    void contactGivesTheHandNoEnergy() {
        QFETCH(double, stiffness);
        QFETCH(double, damping);
        const double perContact = energyGivenToTheHand(damping, stiffness) / contacts;
        QVERIFY2(perContact <= 0.02e-3, qPrintable(QString::number(perContact)));
    }
    void withoutAControllerContactWouldGiveEnergy() { QVERIFY(energyGivenToTheHand(0.0, 4000.0) / contacts > 0.1e-3); }
};

BURIN_TEST(TestHapticLimits, NoApplication)

} // namespace burin::tst_haptic_limits

#include "tst_haptic_limits.moc"
