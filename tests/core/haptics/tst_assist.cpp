// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/force/assist_output.h"
#include "tests/core/haptics/haptic_rig.h"
#include "tests/oracles/allocation_count.h"
#include "tests/test_program.h"

#include <rapidcheck.h>

#include <QtTest>

#include <cmath>
#include <limits>

namespace burin::tst_assist {

using namespace burin::test;

namespace {

constexpr double ceiling = 0.4;

HapticSettings assisting(int forceAxes = 0) {
    HapticSettings settings = Rig::settings();
    settings.stylus.actuated = {};
    settings.stylus.maximumForce = {};
    settings.stylus.maximumStiffness = {};
    settings.stylus.maximumDamping = {};
    settings.stylus.assist = {.rumble = forceAxes == 0, .forceAxes = forceAxes};
    settings.felt.assist = ceiling;
    return settings;
}

/// A hand with the first button pressed, and a tool that something holds.
struct Held {
    Held() {
        hand.buttons = 1;
        motion.normal = {0.0, 0.0, 1.0};
    }
    Assist at(AssistOutput& output, const glm::dvec3& away, int ticks) {
        Assist shown;
        for (int i = 0; i < ticks; ++i) shown = output.advance(away, motion, cutting, hand, 1.0, period);
        return shown;
    }
    Hand hand;
    ToolMotion motion;
    CuttingForce cutting;
};

/// A cut along X with this share of the reference cut's force.
CuttingForce cutOf(double share) {
    CuttingForce cut;
    cut.cuts = true;
    cut.motion = {0.02, 0.0, 0.0};
    cut.energy = 0.7;
    cut.area = 3.0;
    cut.reference = 1000.0 * cut.energy * cut.area / share;
    return cut;
}

bool near(double one, double other, double within = 1e-9) {
    return std::abs(one - other) <= within;
}

} // namespace

/// What a device without motors for the hand shows of contact and cutting.
class TestAssist : public QObject {
    Q_OBJECT
private slots:
    void contactIsTheDepthInDeviceSpace_data() {
        QTest::addColumn<double>("depth"); // mm, setup frame
        QTest::addColumn<double>("scale");
        QTest::addColumn<double>("share");
        QTest::newRow("half") << 2.5 << 1.0 << 0.5;
        QTest::newRow("half, enlarged") << 5.0 << 2.0 << 0.5;
        QTest::newRow("all") << 5.0 << 1.0 << 1.0;
        QTest::newRow("no more than all") << 500.0 << 1.0 << 1.0;
        QTest::newRow("none") << 0.0 << 1.0 << 0.0;
    }
    void contactIsTheDepthInDeviceSpace() {
        QFETCH(double, depth);
        QFETCH(double, scale);
        QFETCH(double, share);
        AssistOutput output(assisting(2));
        Held test;
        test.hand.mapping.scale = scale;
        test.hand.mapping.rotation = glm::angleAxis(0.5 * pi, glm::dvec3(0.0, 0.0, 1.0)); // device X is setup Y
        const Assist shown = test.at(output, {0.0, depth, 0.0}, 200);
        QVERIFY(near(shown.contact, ceiling * share) && near(shown.load, 0.0) && near(shown.ceiling, ceiling));
        QVERIFY(glm::length(shown.force - glm::dvec3(ceiling * share, 0.0, 0.0)) < 1e-9);
        test.motion.normal = glm::dvec3(0.0); // nothing holds the tool: it is only behind
        QVERIFY(near(test.at(output, {0.0, depth, 0.0}, 30).contact, 0.0));
    }

    void loadIsTheShareOfTheReferenceCut() {
        for (const double share : {0.25, 1.0, 3.0}) {
            HapticSettings settings = assisting(2);
            settings.felt.gain = 0.5;
            AssistOutput output(settings);
            Held test;
            test.cutting = cutOf(share);
            const double load = ceiling * std::min(1.0, 0.5 * 0.6 * share);
            const Assist shown = test.at(output, glm::dvec3(0.0), 1000);
            QVERIFY(near(shown.load, load) && near(shown.contact, 0.0));
            QVERIFY(glm::length(shown.force - glm::dvec3(-load, 0.0, 0.0)) < 1e-9); // against the motion
            test.cutting = {};                                                      // the tool rests
            test.cutting.cuts = true;
            const Assist later = test.at(output, glm::dvec3(0.0), 30); // one time constant
            QVERIFY(near(later.load, load / std::exp(1.0), 1e-9));
        }
    }

    /// 20 mm/s is a motion, 1 mm/s counts as rest, in between the load grows.
    void aToolThatRestsHasNoLoad() {
        for (const double speed : {0.5, 1.0, 3.0, 5.0, 200.0}) {
            AssistOutput output(assisting());
            Held test;
            test.cutting = cutOf(1.0);
            test.cutting.motion = {0.0, -speed * period, 0.0};
            const double moving = std::clamp((speed - 1.0) / 4.0, 0.0, 1.0);
            QVERIFY(near(test.at(output, glm::dvec3(0.0), 1000).load, ceiling * 0.6 * moving));
        }
    }

    /// Contact comes first: what cutting adds keeps the sum within the ceiling.
    void togetherTheyStayWithinTheCeiling() {
        QVERIFY(rc::check([] {
            const auto part = [] { return *rc::gen::inRange(-1000, 1001) * 0.02; };
            AssistOutput output(assisting(2));
            Held test;
            test.cutting = cutOf(*rc::gen::inRange(1, 500) * 0.01);
            const glm::dvec3 away(part(), part(), part());
            const Assist shown = test.at(output, away, 400);
            RC_ASSERT(glm::length(shown.force) <= ceiling + 1e-9);
            RC_ASSERT(shown.contact <= ceiling + 1e-9 && shown.load <= ceiling + 1e-9);
            if (glm::length(away) >= AssistOutput::fullDepth)
                RC_ASSERT(glm::length(shown.force) <= ceiling + 1e-9 && near(shown.contact, ceiling, 1e-9));
        }));
    }

    void itRisesAndFallsSteadily() {
        AssistOutput output(assisting(2));
        Held test;
        double before = 0.0;
        for (int i = 1; i <= 100; ++i) { // 0.1 s
            const Assist shown = test.at(output, {9.0, 0.0, 0.0}, 1);
            QVERIFY(near(shown.force.x, ceiling * i / 100.0) && near(shown.contact, ceiling * i / 100.0));
            before = shown.force.x;
        }
        QVERIFY(near(before, ceiling));
        test.hand.clutched = true;
        for (int i = 1; i <= 20; ++i) // 0.02 s
            QVERIFY(near(test.at(output, {9.0, 0.0, 0.0}, 1).force.x, ceiling * (1.0 - i / 20.0)));
        test.hand.clutched = false;
        test.at(output, {9.0, 0.0, 0.0}, 50);
        QVERIFY(output.none().force == glm::dvec3(0.0)); // a fault: at once, and the device stays ready
        QCOMPARE(output.none().ceiling, ceiling);
        QVERIFY(near(test.at(output, {9.0, 0.0, 0.0}, 1).force.x, ceiling / 100.0));
    }

    /// A stick pushes only while a button is held; a vibration pushes nobody.
    void aPushNeedsAButton() {
        HapticSettings settings = assisting(2);
        Held test;
        test.hand.buttons = 0;
        AssistOutput first(settings);
        QVERIFY(test.at(first, {9.0, 0.0, 0.0}, 100).force == glm::dvec3(0.0));
        test.hand.buttons = 2;
        QVERIFY(test.at(first, {9.0, 0.0, 0.0}, 100).force == glm::dvec3(0.0));
        test.hand.buttons = 1;
        QVERIFY(near(test.at(first, {9.0, 0.0, 0.0}, 100).force.x, ceiling));
        settings.forceButtons = 2;
        AssistOutput second(settings);
        QVERIFY(test.at(second, {9.0, 0.0, 0.0}, 100).force == glm::dvec3(0.0));
        test.hand.buttons = 3;
        QVERIFY(near(test.at(second, {9.0, 0.0, 0.0}, 100).force.x, ceiling));
        test.hand.buttons = 0;
        AssistOutput rumble(assisting());
        QVERIFY(near(test.at(rumble, {9.0, 0.0, 0.0}, 100).contact, ceiling));
    }

    void itIsOffForWhomItIsNotMeant() {
        HapticSettings off = assisting();
        off.felt.assist = 0.0;
        QVERIFY(!AssistOutput(off).active());
        off.felt.assist = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!AssistOutput(off).active());
        HapticSettings denied = assisting();
        denied.stylus.assist.permitted = false;
        QVERIFY(!AssistOutput(denied).active());
        QVERIFY(!AssistOutput(Rig::settings()).active());
        HapticSettings much = assisting();
        much.felt.assist = 7.0;
        QCOMPARE(AssistOutput(much).none().ceiling, 1.0);
    }

    /// The whole step: pressed 3 mm into the part, beside stock that it cuts; the samples are those without assist.
    void theBoundaryIsKeptWithoutIt() {
        HapticSettings without = assisting();
        without.felt.assist = 0.0;
        Rig shown(assisting()), bare(without);
        double contact = 0.0, load = 0.0;
        for (Rig* rig : {&shown, &bare}) rig->begin({-10.0, 0.0, 5.0});
        const auto both = [&](const glm::dvec3& to, double speed) {
            Sample last;
            std::vector<Sample> samples;
            shown.onTick = [&](const Sample& sample) {
                samples.push_back(sample);
                const Assist& assist = shown.step.deviceWrench().assist;
                contact = std::max(contact, assist.contact);
                load = std::max(load, assist.load);
                QVERIFY(sample.proxy.tip.z >= floorHeight - 1e-6);
            };
            std::size_t at = 0;
            bare.onTick = [&](const Sample& sample) {
                QVERIFY(at < samples.size() && samples[at].proxy.tip == sample.proxy.tip &&
                        samples[at].force == sample.force && samples[at].flags == sample.flags &&
                        samples[at].cuttingForce == sample.cuttingForce);
                ++at;
            };
            shown.moveTo(to, speed);
            last = bare.moveTo(to, speed);
            return last;
        };
        both({-10.0, 0.0, -3.0}, 40.0);
        QVERIFY(contact == 0.0 && load > 0.0 && load <= ceiling);
        both({-10.0, 0.0, floorHeight - 3.0}, 40.0);
        const Sample last = both({5.0, 0.0, floorHeight - 3.0}, 40.0);
        QVERIFY(last.force == glm::dvec3(0.0));
        QVERIFY(near(shown.step.deviceWrench().assist.contact, ceiling * 3.0 / AssistOutput::fullDepth, 0.02));
        QVERIFY(bare.step.deviceWrench().assist.ceiling == 0.0);
        shown.step.forceWithheld();
        QVERIFY(shown.step.deviceWrench().assist.contact == 0.0);
    }

    void aBadReadingShowsNothing() {
        Rig rig(assisting());
        rig.begin({0.0, 0.0, 5.0});
        rig.moveTo({0.0, 0.0, floorHeight - 5.0}, 50.0);
        rig.rest(200);
        QVERIFY(rig.step.deviceWrench().assist.contact > 0.5 * ceiling);
        StylusState invalid;
        rig.step.advance(invalid, period);
        QVERIFY(rig.step.deviceWrench().assist.contact == 0.0 && rig.step.deviceWrench().assist.load == 0.0);
        const std::size_t before = allocationCount;
        rig.rest(100);
        QCOMPARE(allocationCount.load(), before);
    }
};

BURIN_TEST(TestAssist, NoApplication)

} // namespace burin::tst_assist

#include "tst_assist.moc"
