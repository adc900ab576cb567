// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/seeded_random.h"
#include "core/base/units.h"
#include "core/device/deflection.h"
#include "core/haptics/workspace.h"
#include "tests/core/haptics/haptic_rig.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_workspace {

using namespace burin::test;

namespace {

constexpr double scale = 2.0;

HapticSettings mapped(bool motors = true) {
    HapticSettings settings = Rig::settings();
    if (!motors) settings.stylus.actuated = {};
    settings.mapping.origin = {3, -2, 40};
    settings.mapping.scale = scale;
    return settings;
}

/// A workspace with a hand in it; the tool is always where the hand requests it.
struct WorkspaceRig {
    explicit WorkspaceRig(const HapticSettings& wanted = mapped()) : workspace(wanted) {}
    glm::dvec3 feed(const glm::dvec3& place) {
        Pose pose;
        pose.position = place;
        pose.rotation = turn;
        hand = place;
        last = workspace.map(pose, buttons, &tool, quiet, period);
        tool = last.wanted.tip;
        return tool;
    }
    glm::dvec3 moveTo(const glm::dvec3& target, int ticks = 100) {
        const glm::dvec3 from = hand;
        for (int i = 1; i <= ticks; ++i) feed(glm::mix(from, target, static_cast<double>(i) / ticks));
        return tool;
    }
    Workspace workspace;
    WorkspaceSettings settings;
    glm::dvec3 hand{0.0}, tool{0.0};
    glm::dquat turn = glm::dquat(1, 0, 0, 0);
    Workspace::Place last;
    std::uint32_t buttons = 0;
    bool quiet = true;
};

glm::dquat turnAbout(const glm::dvec3& axis, double angle) {
    return glm::angleAxis(angle, glm::normalize(axis));
}

} // namespace

class TestWorkspace : public QObject {
    Q_OBJECT
private slots:
    void withoutARequestItIsTheMapping() {
        WorkspaceRig rig;
        SeededRandom random(1);
        for (int i = 0; i < 1000; ++i) {
            const glm::dvec3 place = random.within(glm::dvec3(-50), glm::dvec3(50));
            QCOMPARE(rig.feed(place), mapped().mapping.toSetup(place));
        }
    }

    void theRequestedTipNeverJumpsWhateverIsRequested() {
        QVERIFY(rc::check("it moves no farther than the hand does, and rests where the hand rests", [] {
            SeededRandom random(*rc::gen::arbitrary<std::uint64_t>());
            WorkspaceRig rig;
            rig.settings.clutchButton = 2;
            glm::dvec3 before = rig.feed(random.within(glm::dvec3(-40), glm::dvec3(40)));
            for (int request = 0; request < 40; ++request) {
                switch (random.below(5)) {
                case 0:
                    rig.settings.scale = std::exp(random.between(-2.0, 2.0));
                    break;
                case 1:
                    rig.settings.rotation = turnAbout(random.direction(), random.between(-3.0, 3.0));
                    break;
                case 2:
                    rig.settings.clutched = !rig.settings.clutched;
                    break;
                case 3:
                    ++rig.settings.recentrings;
                    break;
                default:
                    rig.buttons ^= 2;
                }
                rig.quiet = random.share() < 0.5;
                rig.workspace.set(rig.settings);
                const double most = std::max(rig.workspace.mapping().scale, rig.settings.scale.value_or(0.0));
                const glm::dvec3 from = rig.hand;
                const glm::dvec3 target = random.share() < 0.3 ? from : random.within(glm::dvec3(-40), glm::dvec3(40));
                for (int i = 1; i <= 20; ++i) {
                    const glm::dvec3 place = glm::mix(from, target, i / 20.0);
                    const double moved = glm::length(place - rig.hand);
                    const glm::dvec3 tip = rig.feed(place);
                    RC_ASSERT(glm::length(tip - before) <= 1.5 * most * moved + 1e-11);
                    before = tip;
                }
            }
        }));
    }

    void theClutchLetsTheHandGoBack() {
        WorkspaceRig rig;
        rig.settings.clutchButton = 2;
        rig.workspace.set(rig.settings);
        rig.feed({0, 0, 0});
        const glm::dvec3 there = rig.moveTo({40, 0, 0});
        rig.buttons = 2;
        QVERIFY(glm::length(rig.moveTo({-40, 10, 0}) - there) < 1e-11);
        rig.buttons = 0;
        QVERIFY(glm::length(rig.moveTo({-40, 10, 0}) - there) < 1e-11);
        QVERIFY(glm::length(rig.moveTo({-20, 10, 5}) - there - glm::dvec3(40, 0, 10)) < 1e-11);
    }

    void aTurnWaitsUntilTheHandFeelsNothing() {
        WorkspaceRig rig;
        rig.feed({10, 0, 0});
        rig.quiet = false;
        rig.settings.rotation = turnAbout({0, 0, 1}, 0.5 * pi);
        rig.workspace.set(rig.settings);
        const glm::dvec3 there = rig.tool;
        QVERIFY(glm::length(rig.moveTo({11, 0, 0}) - there - glm::dvec3(scale, 0, 0)) < 1e-11);
        rig.quiet = true;
        rig.feed(rig.hand);
        const glm::dvec3 turned = rig.tool;
        QVERIFY(glm::length(turned - there - glm::dvec3(scale, 0, 0)) < 1e-11);
        QVERIFY(glm::length(rig.moveTo({12, 0, 0}) - turned - glm::dvec3(0, scale, 0)) < 1e-11);
    }

    void aScaleComesInSlowlyUnderForce() {
        WorkspaceRig rig;
        rig.feed({10, 0, 0});
        rig.quiet = false;
        rig.settings.scale = 0.5;
        rig.workspace.set(rig.settings);
        for (int i = 0; i < 100; ++i) rig.feed(rig.hand);
        QVERIFY(std::abs(rig.workspace.mapping().scale - scale * std::exp(-0.2)) < 1e-9);
        for (int i = 0; i < 1000; ++i) rig.feed(rig.hand);
        QCOMPARE(rig.workspace.mapping().scale, 0.5);
        rig.quiet = true;
        rig.settings.scale = 5.0;
        rig.workspace.set(rig.settings);
        rig.feed(rig.hand);
        QCOMPARE(rig.workspace.mapping().scale, 5.0);
    }

    void recentringBringsAHandThatWorksBackToTheMiddle() {
        WorkspaceRig rig;
        SeededRandom random(4);
        rig.feed({50, -30, 20});
        const glm::dvec3 work = rig.tool; // the hand steers the tool visually about this point
        ++rig.settings.recentrings;
        rig.workspace.set(rig.settings);
        double farthest = 0.0;
        int ticks = 0;
        for (; rig.workspace.recentring() && ticks < 60'000; ++ticks) {
            const double angle = 0.01 * ticks;
            const glm::dvec3 request = work + 10.0 * glm::dvec3(std::cos(angle), std::sin(angle), 0);
            rig.feed(rig.hand + clampLength((request - rig.tool) / scale, 0.1));
            if (ticks > 1000) farthest = std::max(farthest, glm::length(rig.tool - work));
        }
        QVERIFY(ticks < 20'000);
        QVERIFY(glm::length(rig.hand) <= Workspace::recentred * 80.0 + 0.1);
        QVERIFY(farthest < 11.0);
    }

    void rateControlDrivesTheToolAndStopsWhenLetGo() {
        WorkspaceRig rig(mapped(false));
        rig.settings.control = WorkspaceControl::rate;
        rig.settings.region = {{-1000, -50, -50}, {200, 50, 50}};
        rig.workspace.set(rig.settings);
        rig.feed({0, 0, 0});
        const glm::dvec3 start = rig.tool;
        rig.moveTo({20, 0, 0}, 1); // half of full deflection
        for (int i = 0; i < 499; ++i) rig.feed({20, 0, 0});
        const double speed = scale * Workspace::topSpeed * deflectionResponse(0.5); // mm/s
        QVERIFY(glm::length(rig.tool - start - glm::dvec3(0.5 * speed, 0, 0)) < 1e-9);
        QVERIFY(glm::length(rig.last.drive - glm::dvec3(speed, 0, 0)) < 1e-9);
        const glm::dvec3 there = rig.moveTo({0, 0, 0}, 1);
        for (int i = 0; i < 1000; ++i) rig.feed({0.5, 0.5, 0}); // the mechanical play of a cap
        QCOMPARE(rig.tool, there);
        for (int i = 0; i < 10'000; ++i) rig.feed({40, 0, 0});
        QCOMPARE(rig.tool.x, 200.0);
    }

    void aStylusWithMotorsIsNeverRateControlled() {
        WorkspaceRig rig;
        rig.settings.control = WorkspaceControl::rate;
        rig.workspace.set(rig.settings);
        rig.feed({10, 0, 0});
        QCOMPARE(rig.feed({20, 0, 0}), mapped().mapping.toSetup({20, 0, 0}));
    }

    void theAxisTurnsNoFasterThanAHand() {
        WorkspaceRig rig;
        rig.feed({10, 0, 0});
        rig.settings.rotation = turnAbout({1, 0, 0}, 1.0);
        rig.workspace.set(rig.settings);
        glm::dvec3 before = rig.last.wanted.axis;
        for (int i = 0; i < 1000; ++i) {
            rig.feed({10, 0, 0});
            QVERIFY(angleBetween(before, rig.last.wanted.axis) <= AxisFollower::speed * period + 1e-9);
            before = rig.last.wanted.axis;
        }
        QVERIFY(glm::length(before - turnAbout({1, 0, 0}, 1.0) * glm::dvec3(0, 0, 1)) < 1e-9);
        rig.settings.clutched = true;
        rig.workspace.set(rig.settings);
        rig.turn = turnAbout({0, 1, 0}, 0.7);
        rig.feed({10, 0, 0});
        QCOMPARE(rig.last.wanted.axis, before); // follows the tool
    }

    void nonsenseIsNotTaken() {
        WorkspaceRig rig;
        rig.feed({10, 0, 0});
        rig.settings.scale = std::nan("");
        rig.settings.rotation = glm::dquat(0, 0, 0, 0);
        rig.workspace.set(rig.settings);
        rig.feed({11, 0, 0});
        rig.settings.scale = 0.0;
        rig.settings.rotation = glm::dquat(std::nan(""), 0, 0, 0);
        rig.workspace.set(rig.settings);
        QCOMPARE(rig.feed({12, 0, 0}), mapped().mapping.toSetup({12, 0, 0}));
    }

    void aHandThatPressesFeelsNoKick() {
        HapticSettings settings = Rig::settings();
        Rig rig(settings, ballTool(), stockOnPart(0, false));
        SeededRandom random(8);
        rig.begin({0, 0, 5});
        rig.moveTo({0, 0, floorHeight - 4.0}, 50.0);
        WorkspaceSettings workspace;
        glm::dvec3 before = rig.rest(1).force;
        double kick = 0.0, largest = 0.0;
        int quietTicks = 0;
        rig.onTick = [&](const Sample& sample) {
            const double grown = glm::length(sample.force) - glm::length(before);
            kick = std::max(kick, grown);
            largest = std::max(largest, glm::length(sample.force));
            quietTicks += workspace.clutched && sample.force == glm::dvec3(0.0) ? 1 : 0;
            before = sample.force;
        };
        for (int request = 0; request < 200; ++request) {
            switch (random.below(4)) {
            case 0:
                workspace.scale = std::exp(random.between(-1.0, 1.0));
                break;
            case 1:
                workspace.rotation = turnAbout({0, 0, 1}, random.between(-3.0, 3.0));
                break;
            case 2:
                workspace.clutched = !workspace.clutched;
                break;
            default:
                ++workspace.recentrings;
            }
            rig.step.setWorkspace(workspace);
            rig.moveTo({0, 0, floorHeight - random.between(-1.0, 6.0)}, 30.0);
            rig.rest(50);
        }
        QVERIFY2(kick <= 0.16 + 1e-9, qPrintable(QString::number(kick))); // the slew limit
        QVERIFY(largest > 0.5);
        QVERIFY(quietTicks > 1000);
    }

    void withTheClutchInTheHandCarriesNothingAboutAndTheToolStays() {
        Rig rig(Rig::settings(), ballTool(), stockOnPart(0, false));
        rig.begin({0, 0, 5});
        rig.moveTo({0, 0, floorHeight - 4.0}, 50.0);
        QVERIFY(rig.rest(100).force.z > 1.0);
        WorkspaceSettings workspace;
        workspace.clutched = true;
        rig.step.setWorkspace(workspace);
        const glm::dvec3 tool = rig.rest(20).proxy.tip;
        const Sample away = rig.moveTo({10, 10, floorHeight + 20.0}, 100.0);
        QCOMPARE(away.force, glm::dvec3(0.0));
        QVERIFY(glm::length(away.proxy.tip - tool) < 1e-3);
        workspace.clutched = false;
        rig.step.setWorkspace(workspace);
        const Sample on = rig.moveTo({12, 10, floorHeight + 20.0}, 50.0);
        QVERIFY(glm::length(on.proxy.tip - tool - glm::dvec3(2, 0, 0)) < 1e-3);
        QVERIFY(rig.moveTo({12, 10, floorHeight + 18.0}, 50.0).force.z > 0.5); // the floor again
    }
};

BURIN_TEST(TestWorkspace, NoApplication)

} // namespace burin::tst_workspace

#include "tst_workspace.moc"
