// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/force/coupling.h"
#include "core/haptics/force/suggested_gains.h"
#include "tests/core/haptics/haptic_rig.h"
#include "tests/oracles/simulated_handle.h"
#include "tests/test_program.h"

#include <QtTest>

#include <algorithm>
#include <rapidcheck.h>

namespace burin::tst_suggested_gains {

using namespace burin::test;

namespace {

constexpr double handleDamping = 0.5; // N·s/m
constexpr double handleMass = 0.1;    // kg

/// A device whose stated stiffness is what its handle's own damping takes at 1 kHz: K = 2 b / T.
StylusDescription dampedStylus() {
    StylusDescription stylus = desktopStylus();
    stylus.maximumStiffness.value = 2.0 * handleDamping / 0.001;
    stylus.maximumForce.value = 100.0; // so that no clamp hides the loop
    return stylus;
}

/// What a trial measures of a device. Times in ms.
TrialFigures measured(double median, double usual, double latency = 0.0) {
    TrialFigures trial;
    trial.readings = 1000;
    trial.medianInterval = 1e-3 * median;
    trial.usualInterval = 1e-3 * usual;
    trial.latency = 1e-3 * latency;
    return trial;
}

/// How far a handle that nobody holds still swings on a held spring after 12 s, as a share of where it was let go. No
/// part of the product: the force is -K x of the last reading.
double swingsOn(double stiffness, double hold, std::size_t delay) {
    SimulatedHandle handle(noGrip, {handleMass, handleDamping, 0.0, delay}, {0.0, 0.0, 1.0});
    double farthest = 0.0;
    const int ticks = static_cast<int>(12.0 / hold);
    for (int i = 0; i < ticks && farthest < 100.0; ++i) {
        handle.hold(-stiffness * handle.reading() / millimetresPerMetre, glm::dvec3(0.0), glm::dvec3(0.0), hold);
        if (i > ticks / 2) farthest = std::max(farthest, std::abs(handle.position().z));
        if (std::abs(handle.position().z) > 100.0) farthest = 100.0;
    }
    return farthest;
}

/// The most energy, mJ, that a contact of the whole step gives to a hand: once a second 5 mm into the floor and out.
double energyOfContact(const GainLimits& gains, const SimulatedGrip& grip, const SimulatedMechanism& mechanism) {
    HapticSettings settings = Rig::settings();
    settings.stylus = dampedStylus();
    settings.stylus.positionStep = {mechanism.encoder, "made up"};
    settings.stylus.delay = {static_cast<double>(mechanism.delay) * period, "made up"};
    settings.gains = gains;
    Rig rig(settings, ballTool(), stockOnPart(0, false));
    constexpr int cycle = 1000, cycles = 3; // ticks
    constexpr double reach = 5.0;           // mm
    SimulatedHandle handle(grip, mechanism, {0.0, 0.0, floorHeight + reach});
    rig.begin(handle.reading());
    double worst = -1.0, before = 0.0;
    for (int i = 0; i < cycle * cycles; ++i) {
        rig.feed(handle.reading());
        const double intent = floorHeight + reach * std::cos(2.0 * pi * i / cycle);
        handle.hold(rig.step.deviceWrench().force, {0.0, 0.0, intent}, glm::dvec3(0.0), period);
        if ((i + 1) % cycle != 0) continue;
        worst = std::max(worst, handle.energy() - before);
        before = handle.energy();
    }
    return 1e3 * worst;
}

} // namespace

class TestSuggestedGains : public QObject {
    Q_OBJECT
private slots:
    /// 0.8 b / (T/2 + d), and 0.8 of twice the friction over a step, in plain numbers. b = 0.5 N·s/m, T and d in ms.
    void theStiffnessIsThatOfTheory_data() {
        QTest::addColumn<double>("median");
        QTest::addColumn<double>("usual");
        QTest::addColumn<double>("latency");
        QTest::addColumn<double>("friction");
        QTest::addColumn<double>("ceiling");
        QTest::addColumn<double>("stiffness");
        QTest::addColumn<int>("bound");
        const auto row = [](const char* name, double median, double usual, double latency, double friction,
                            double ceiling, double stiffness, GainBound bound) {
            QTest::newRow(name) << median << usual << latency << friction << ceiling << stiffness
                                << static_cast<int>(bound);
        };
        const double none = GainLimits::none;
        row("as the device states", 1.0, 1.0, 0.0, 0.0, none, 800.0, GainBound::device);
        row("faster than it states", 0.25, 0.25, 0.0, 0.0, none, 800.0, GainBound::device);
        row("slow", 2.0, 2.0, 0.0, 0.0, none, 400.0, GainBound::rate);
        row("late readings", 1.0, 4.0, 0.0, 0.0, none, 200.0, GainBound::jitter);
        row("latency", 1.0, 1.0, 3.5, 0.0, none, 100.0, GainBound::latency);
        row("coarse encoders", 1.0, 1.0, 0.0, 0.01, none, 320.0, GainBound::encoders); // steps of 0.05 mm
        row("fine enough encoders", 1.0, 1.0, 0.0, 1.0, none, 800.0, GainBound::device);
        row("a user's maximum", 1.0, 1.0, 0.5, 0.01, 150.0, 150.0, GainBound::ceiling);
        row("a maximum that is not reached", 1.0, 1.0, 3.5, 0.0, 150.0, 100.0, GainBound::latency);
    }
    void theStiffnessIsThatOfTheory() {
        QFETCH(double, median);
        QFETCH(double, usual);
        QFETCH(double, latency);
        QFETCH(double, friction);
        QFETCH(double, ceiling);
        QFETCH(double, stiffness);
        QFETCH(int, bound);
        StylusDescription stylus = dampedStylus();
        stylus.positionStep = {0.05, "made up"};
        const auto gains = suggestGains(stylus, measured(median, usual, latency), {ceiling, friction});
        QVERIFY(gains);
        QCOMPARE(gains->stiffness, stiffness);
        QCOMPARE(static_cast<int>(gains->bound), bound);
        QCOMPARE(gains->latencyMeasured, latency > 0.0);
        // A damper that is as late as the spring, on a handle of 0.1 kg: 0.3 of 0.6 m / lag, or of 4 N·s/m.
        const double lag = 1e-3 * (usual + latency);
        QVERIFY(std::abs(gains->damping - 0.3 * std::min(4.0, 0.06 / lag)) < 1e-12);
    }

    void whatIsNotKnownSuggestsNothing() {
        QVERIFY(!suggestGains(StylusDescription{}, measured(1.0, 1.0)));
        TrialFigures brief = measured(1.0, 1.0);
        brief.readings = 199;
        QVERIFY(!suggestGains(dampedStylus(), brief));
        // Without an echo the stated latency counts; the larger one, if there are both.
        StylusDescription stated = dampedStylus();
        stated.delay = {0.0035, "made up"};
        QCOMPARE(suggestGains(stated, measured(1.0, 1.0))->stiffness, 100.0);
        QCOMPARE(suggestGains(stated, measured(1.0, 1.0, 1.0))->stiffness, 100.0);
        // So does the smallest step that was seen.
        TrialFigures seen = measured(1.0, 1.0);
        seen.smallestStep = 0.05;
        QCOMPARE(suggestGains(dampedStylus(), seen, {GainLimits::none, 0.01})->stiffness, 320.0);
    }

    /// Whatever was measured: never above the device's limits, what a session takes without it, and the user's maximum.
    void theLimitsHold() {
        QVERIFY(rc::check([] {
            StylusDescription stylus = dampedStylus();
            stylus.maximumStiffness.value = 1e-2 * *rc::gen::inRange(100, 1'000'000);
            stylus.maximumDamping.value = 1e-2 * *rc::gen::inRange(0, 3000);
            stylus.delay = {1e-6 * *rc::gen::inRange(0, 5000), "made up"};
            stylus.handleMass = {1e-3 * *rc::gen::inRange(0, 300), "made up"};
            const double usual = 1e-3 * *rc::gen::inRange(1000, 20'000), latency = 1e-3 * *rc::gen::inRange(0, 20'000);
            const double ceiling = *rc::gen::inRange(1, 2000);
            const auto gains = suggestGains(stylus, measured(1.0, usual, latency), {ceiling, 0.0});
            RC_ASSERT(gains && gains->stiffness > 0.0);
            const CouplingGains without = couplingGains(stylus, HapticSettings::safeShare, 0.001);
            RC_ASSERT(gains->stiffness <= without.stiffness * (1.0 + 1e-12) && gains->stiffness <= ceiling);
            RC_ASSERT(gains->damping <= without.damping + 1e-12);
            HapticSettings settings;
            settings.stylus = stylus;
            settings.gains = gains->limits();
            RC_ASSERT(boundaryGains(settings).stiffness == gains->stiffness ||
                      boundaryGains(settings).stiffness == without.stiffness);
            RC_ASSERT(guideGains(settings).stiffness <= boundaryGains(settings).stiffness);
        }));
    }

    /// A spring alone on a handle that nobody holds: with the suggested stiffness it comes to rest, with twice as much
    /// it swings ever farther.
    void theoryIsRightAboutTheBareHandle_data() {
        QTest::addColumn<double>("hold");
        QTest::addColumn<int>("delay");
        for (const double hold : {0.001, 0.002, 0.004})
            for (const int delay : {0, 1, 2, 3}) QTest::addRow("%g ms, %d late", 1e3 * hold, delay) << hold << delay;
    }
    void theoryIsRightAboutTheBareHandle() {
        QFETCH(double, hold);
        QFETCH(int, delay);
        const double milliseconds = 1e3 * hold;
        const auto gains = suggestGains(dampedStylus(), measured(milliseconds, milliseconds, delay * milliseconds));
        QVERIFY(gains);
        const double still = swingsOn(gains->stiffness, hold, static_cast<std::size_t>(delay));
        const double twice = swingsOn(2.0 * gains->stiffness, hold, static_cast<std::size_t>(delay));
        QVERIFY2(still < 0.5, qPrintable(QString::number(still)));
        QVERIFY2(twice > 2.0, qPrintable(QString::number(twice)));
    }

    /// The whole step with the suggested gains gives no hand more than 0.02 mJ per contact.
    void contactWithTheSuggestedGainsGivesNoEnergy_data() {
        QTest::addColumn<int>("delay");
        for (const int delay : {0, 1, 2, 3}) QTest::addRow("%d ticks late", delay) << delay;
    }
    void contactWithTheSuggestedGainsGivesNoEnergy() {
        QFETCH(int, delay);
        const auto gains = suggestGains(dampedStylus(), measured(1.0, 1.0, delay));
        QVERIFY(gains);
        for (const SimulatedGrip& grip : {lightGrip, middleGrip, firmGrip})
            for (const double encoder : {0.02, 0.055}) {
                const double energy = energyOfContact(
                    gains->limits(), grip, {handleMass, handleDamping, encoder, static_cast<std::size_t>(delay)});
                QVERIFY2(energy <= 0.02, qPrintable(QString::number(energy)));
            }
    }

    /// The hand feels the kept stiffness: a millimetre behind the floor, at rest.
    void theHandFeelsTheKeptStiffness() {
        const auto felt = [](const GainLimits& gains) {
            HapticSettings settings = Rig::settings();
            settings.gains = gains;
            Rig rig(settings, ballTool(), stockOnPart(0, false));
            rig.begin({0, 0, floorHeight + 2.0});
            rig.moveTo({0, 0, floorHeight - 1.0}, 20.0);
            return rig.rest(200).force.z;
        };
        QVERIFY(std::abs(felt({}) - 0.32) < 0.004); // 0.8 of 400 N/m
        QVERIFY(std::abs(felt({100.0, 1.0}) - 0.1) < 0.002);
        QVERIFY(std::abs(felt({5000.0, 1.0}) - 0.32) < 0.004);
    }

    void thePreviousGainsComeBack() {
        KeptGains gains;
        gains.use({100.0, 1.0});
        gains.use({100.0, 1.0}); // changes nothing, and loses nothing
        gains.use({50.0, 0.5});
        gains.request.ceiling = 40.0;
        QCOMPARE(gains.inForce(), (GainLimits{40.0, 0.5}));
        gains.restore();
        QCOMPARE(gains.now, (GainLimits{100.0, 1.0}));
        gains.restore();
        QCOMPARE(gains.now, (GainLimits{50.0, 0.5}));
    }
};

BURIN_TEST(TestSuggestedGains, NoApplication)

} // namespace burin::tst_suggested_gains

#include "tst_suggested_gains.moc"
