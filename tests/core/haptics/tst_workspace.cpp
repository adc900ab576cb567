// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/seeded_random.h"
#include "core/base/units.h"
#include "core/device/deflection.h"
#include "core/haptics/workspace.h"
#include "tests/core/haptics/haptic_bench.h"

#include <QtTest>
#include <rapidcheck.h>

using namespace burin;
using namespace burin::test;

namespace {

constexpr double scale = 2.0;

HapticSettings mapped(bool motors = true) {
    HapticSettings settings = Bench::settings();
    if (!motors) settings.stylus.actuated = {};
    settings.mapping.origin = {3, -2, 40};
    settings.mapping.scale = scale;
    return settings;
}

/// A workspace with a hand in it; the tool is where the hand wants it.
struct WorkspaceBench {
    explicit WorkspaceBench(const HapticSettings& wanted = mapped()) : workspace(wanted) {}
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
    void withoutAWishItIsTheMapping() {
        WorkspaceBench bench;
        SeededRandom random(1);
        for (int i = 0; i < 1000; ++i) {
            const glm::dvec3 place = random.within(glm::dvec3(-50), glm::dvec3(50));
            QCOMPARE(bench.feed(place), mapped().mapping.toSetup(place));
        }
    }

    void theWantedTipNeverJumpsWhateverIsWished() {
        QVERIFY(rc::check("it moves no farther than the hand does, and rests where the hand rests", [] {
            SeededRandom random(*rc::gen::arbitrary<std::uint64_t>());
            WorkspaceBench bench;
            bench.settings.clutchButton = 2;
            glm::dvec3 before = bench.feed(random.within(glm::dvec3(-40), glm::dvec3(40)));
            for (int wish = 0; wish < 40; ++wish) {
                switch (random.below(5)) {
                case 0:
                    bench.settings.scale = std::exp(random.between(-2.0, 2.0));
                    break;
                case 1:
                    bench.settings.rotation = turnAbout(random.direction(), random.between(-3.0, 3.0));
                    break;
                case 2:
                    bench.settings.clutched = !bench.settings.clutched;
                    break;
                case 3:
                    ++bench.settings.recentrings;
                    break;
                default:
                    bench.buttons ^= 2;
                }
                bench.quiet = random.share() < 0.5;
                bench.workspace.set(bench.settings);
                const double most = std::max(bench.workspace.mapping().scale, bench.settings.scale.value_or(0.0));
                const glm::dvec3 from = bench.hand;
                const glm::dvec3 target = random.share() < 0.3 ? from : random.within(glm::dvec3(-40), glm::dvec3(40));
                for (int i = 1; i <= 20; ++i) {
                    const glm::dvec3 place = glm::mix(from, target, i / 20.0);
                    const double moved = glm::length(place - bench.hand);
                    const glm::dvec3 tip = bench.feed(place);
                    RC_ASSERT(glm::length(tip - before) <= 1.5 * most * moved + 1e-11);
                    before = tip;
                }
            }
        }));
    }

    void theClutchLetsTheHandGoBack() {
        WorkspaceBench bench;
        bench.settings.clutchButton = 2;
        bench.workspace.set(bench.settings);
        bench.feed({0, 0, 0});
        const glm::dvec3 there = bench.moveTo({40, 0, 0});
        bench.buttons = 2;
        QVERIFY(glm::length(bench.moveTo({-40, 10, 0}) - there) < 1e-11);
        bench.buttons = 0;
        QVERIFY(glm::length(bench.moveTo({-40, 10, 0}) - there) < 1e-11);
        QVERIFY(glm::length(bench.moveTo({-20, 10, 5}) - there - glm::dvec3(40, 0, 10)) < 1e-11);
    }

    void aTurnWaitsUntilTheHandFeelsNothing() {
        WorkspaceBench bench;
        bench.feed({10, 0, 0});
        bench.quiet = false;
        bench.settings.rotation = turnAbout({0, 0, 1}, 0.5 * pi);
        bench.workspace.set(bench.settings);
        const glm::dvec3 there = bench.tool;
        QVERIFY(glm::length(bench.moveTo({11, 0, 0}) - there - glm::dvec3(scale, 0, 0)) < 1e-11);
        bench.quiet = true;
        bench.feed(bench.hand);
        const glm::dvec3 turned = bench.tool;
        QVERIFY(glm::length(turned - there - glm::dvec3(scale, 0, 0)) < 1e-11);
        QVERIFY(glm::length(bench.moveTo({12, 0, 0}) - turned - glm::dvec3(0, scale, 0)) < 1e-11);
    }

    void aScaleComesInSlowlyUnderForce() {
        WorkspaceBench bench;
        bench.feed({10, 0, 0});
        bench.quiet = false;
        bench.settings.scale = 0.5;
        bench.workspace.set(bench.settings);
        for (int i = 0; i < 100; ++i) bench.feed(bench.hand);
        QVERIFY(std::abs(bench.workspace.mapping().scale - scale * std::exp(-0.2)) < 1e-9);
        for (int i = 0; i < 1000; ++i) bench.feed(bench.hand);
        QCOMPARE(bench.workspace.mapping().scale, 0.5);
        bench.quiet = true;
        bench.settings.scale = 5.0;
        bench.workspace.set(bench.settings);
        bench.feed(bench.hand);
        QCOMPARE(bench.workspace.mapping().scale, 5.0);
    }

    void recentringBringsAHandThatWorksBackToTheMiddle() {
        WorkspaceBench bench;
        SeededRandom random(4);
        bench.feed({50, -30, 20});
        const glm::dvec3 work = bench.tool; // the hand steers the tool about this place by the eye
        ++bench.settings.recentrings;
        bench.workspace.set(bench.settings);
        double farthest = 0.0;
        int ticks = 0;
        for (; bench.workspace.recentring() && ticks < 60'000; ++ticks) {
            const double angle = 0.01 * ticks;
            const glm::dvec3 wish = work + 10.0 * glm::dvec3(std::cos(angle), std::sin(angle), 0);
            bench.feed(bench.hand + clampLength((wish - bench.tool) / scale, 0.1));
            if (ticks > 1000) farthest = std::max(farthest, glm::length(bench.tool - work));
        }
        QVERIFY(ticks < 20'000);
        QVERIFY(glm::length(bench.hand) <= Workspace::recentred * 80.0 + 0.1);
        QVERIFY(farthest < 11.0);
    }

    void rateControlDrivesTheToolAndStopsWhenLetGo() {
        WorkspaceBench bench(mapped(false));
        bench.settings.control = WorkspaceControl::rate;
        bench.settings.region = {{-1000, -50, -50}, {200, 50, 50}};
        bench.workspace.set(bench.settings);
        bench.feed({0, 0, 0});
        const glm::dvec3 start = bench.tool;
        bench.moveTo({20, 0, 0}, 1); // half of full deflection
        for (int i = 0; i < 499; ++i) bench.feed({20, 0, 0});
        const double speed = scale * Workspace::topSpeed * deflectionResponse(0.5); // mm/s
        QVERIFY(glm::length(bench.tool - start - glm::dvec3(0.5 * speed, 0, 0)) < 1e-9);
        QVERIFY(glm::length(bench.last.drive - glm::dvec3(speed, 0, 0)) < 1e-9);
        const glm::dvec3 there = bench.moveTo({0, 0, 0}, 1);
        for (int i = 0; i < 1000; ++i) bench.feed({0.5, 0.5, 0}); // what a cap has of play
        QCOMPARE(bench.tool, there);
        for (int i = 0; i < 10'000; ++i) bench.feed({40, 0, 0});
        QCOMPARE(bench.tool.x, 200.0);
    }

    void aStylusWithMotorsIsNeverRateControlled() {
        WorkspaceBench bench;
        bench.settings.control = WorkspaceControl::rate;
        bench.workspace.set(bench.settings);
        bench.feed({10, 0, 0});
        QCOMPARE(bench.feed({20, 0, 0}), mapped().mapping.toSetup({20, 0, 0}));
    }

    void theAxisTurnsNoFasterThanAHand() {
        WorkspaceBench bench;
        bench.feed({10, 0, 0});
        bench.settings.rotation = turnAbout({1, 0, 0}, 1.0);
        bench.workspace.set(bench.settings);
        glm::dvec3 before = bench.last.wanted.axis;
        for (int i = 0; i < 1000; ++i) {
            bench.feed({10, 0, 0});
            QVERIFY(angleBetween(before, bench.last.wanted.axis) <= AxisFollower::speed * period + 1e-9);
            before = bench.last.wanted.axis;
        }
        QVERIFY(glm::length(before - turnAbout({1, 0, 0}, 1.0) * glm::dvec3(0, 0, 1)) < 1e-9);
        bench.settings.clutched = true;
        bench.workspace.set(bench.settings);
        bench.turn = turnAbout({0, 1, 0}, 0.7);
        bench.feed({10, 0, 0});
        QCOMPARE(bench.last.wanted.axis, before); // stays with the tool
    }

    void nonsenseIsNotTaken() {
        WorkspaceBench bench;
        bench.feed({10, 0, 0});
        bench.settings.scale = std::nan("");
        bench.settings.rotation = glm::dquat(0, 0, 0, 0);
        bench.workspace.set(bench.settings);
        bench.feed({11, 0, 0});
        bench.settings.scale = 0.0;
        bench.settings.rotation = glm::dquat(std::nan(""), 0, 0, 0);
        bench.workspace.set(bench.settings);
        QCOMPARE(bench.feed({12, 0, 0}), mapped().mapping.toSetup({12, 0, 0}));
    }

    void aHandThatPressesFeelsNoKick() {
        HapticSettings settings = Bench::settings();
        Bench bench(settings, ballTool(), stockOnPart(0, false));
        SeededRandom random(8);
        bench.begin({0, 0, 5});
        bench.moveTo({0, 0, floorHeight - 4.0}, 50.0);
        WorkspaceSettings workspace;
        glm::dvec3 before = bench.rest(1).force;
        double kick = 0.0, largest = 0.0;
        int quietTicks = 0;
        bench.onTick = [&](const Sample& sample) {
            const double grown = glm::length(sample.force) - glm::length(before);
            kick = std::max(kick, grown);
            largest = std::max(largest, glm::length(sample.force));
            quietTicks += workspace.clutched && sample.force == glm::dvec3(0.0) ? 1 : 0;
            before = sample.force;
        };
        for (int wish = 0; wish < 200; ++wish) {
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
            bench.step.setWorkspace(workspace);
            bench.moveTo({0, 0, floorHeight - random.between(-1.0, 6.0)}, 30.0);
            bench.rest(50);
        }
        QVERIFY2(kick <= 0.16 + 1e-9, qPrintable(QString::number(kick))); // the slew
        QVERIFY(largest > 0.5);
        QVERIFY(quietTicks > 1000);
    }

    void withTheClutchInTheHandCarriesNothingAboutAndTheToolStays() {
        Bench bench(Bench::settings(), ballTool(), stockOnPart(0, false));
        bench.begin({0, 0, 5});
        bench.moveTo({0, 0, floorHeight - 4.0}, 50.0);
        QVERIFY(bench.rest(100).force.z > 1.0);
        WorkspaceSettings workspace;
        workspace.clutched = true;
        bench.step.setWorkspace(workspace);
        const glm::dvec3 tool = bench.rest(20).proxy.tip;
        const Sample away = bench.moveTo({10, 10, floorHeight + 20.0}, 100.0);
        QCOMPARE(away.force, glm::dvec3(0.0));
        QVERIFY(glm::length(away.proxy.tip - tool) < 1e-3);
        workspace.clutched = false;
        bench.step.setWorkspace(workspace);
        const Sample on = bench.moveTo({12, 10, floorHeight + 20.0}, 50.0);
        QVERIFY(glm::length(on.proxy.tip - tool - glm::dvec3(2, 0, 0)) < 1e-3);
        QVERIFY(bench.moveTo({12, 10, floorHeight + 18.0}, 50.0).force.z > 0.5); // the floor again
    }
};

QTEST_APPLESS_MAIN(TestWorkspace)
#include "tst_workspace.moc"
