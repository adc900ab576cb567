// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/core/haptics/haptic_rig.h"
#include "tests/oracles/random_number.h"
#include "tests/test_program.h"

#include <QtTest>
#include <rapidcheck.h>

namespace burin::tst_haptic_step {

using namespace burin::test;

namespace {

std::uint64_t removedUnits(const Sample& sample) {
    std::uint64_t units = 0;
    for (const RemovedMaterial& removed : sample.removed) units += removed.units;
    return units;
}

/// Overlap of a shank (a cylinder) with everything except air, mm of line, by checking the voxels' lines one by one.
double shankOverlap(const RunVolume& volume, const Tool& tool, const glm::dvec3& tip) {
    const Grid& grid = volume.grid();
    const double low = tip.z + tool.cutter.fluteLength, high = tip.z + tool.cutter.stickOut;
    double overlap = 0.0;
    for (std::int32_t v = 0; v < grid.lineCountV(); ++v)
        for (std::int32_t u = 0; u < grid.lineCountU(); ++u) {
            const glm::dvec2 centre = grid.lineCentre({u, v});
            if (glm::length(centre - glm::dvec2(tip)) >= 0.5 * tool.cutter.shankDiameter) continue;
            RunPosition from = 0;
            for (const Segment& segment : volume.line({u, v})) {
                const double a = std::max(low, grid.toMillimetres(from));
                const double b = std::min(high, grid.toMillimetres(segment.end()));
                if (segment.property() != airProperty) overlap = std::max(overlap, b - a);
                from = segment.end();
            }
        }
    return overlap;
}

} // namespace

class TestHapticStep : public QObject {
    Q_OBJECT
private slots:
    void mappingGoesThereAndBack() {
        QVERIFY(rc::check([] {
            WorkspaceMapping mapping;
            mapping.origin = {randomNumber(-99, 99), randomNumber(-99, 99), randomNumber(-99, 99)};
            mapping.rotation = glm::angleAxis(randomNumber(-3, 3),
                                              glm::normalize(glm::dvec3(randomNumber(-1, 1), 1, randomNumber(-1, 1))));
            mapping.scale = randomNumber(0.1, 10.0);
            const glm::dvec3 device(randomNumber(-200, 200), randomNumber(-200, 200), randomNumber(-200, 200));
            RC_ASSERT(glm::length(mapping.toDevice(mapping.toSetup(device)) - device) < 1e-9);
            const glm::dvec3 moved = mapping.toSetup(device + glm::dvec3(1, 0, 0)) - mapping.toSetup(device);
            RC_ASSERT(std::abs(glm::length(moved) - mapping.scale) < 1e-9);
        }));
    }

    void steadyPressFeelsTheSpring_data() {
        QTest::addColumn<double>("scale");
        QTest::addColumn<double>("turn");
        QTest::addColumn<double>("depth");
        QTest::newRow("one to one") << 1.0 << 0.0 << 2.0;
        QTest::newRow("workpiece three times as large as the hand's space") << 3.0 << 0.0 << 4.0;
        QTest::newRow("small workpiece, device turned over") << 0.5 << 2.1 << 3.0;
        QTest::newRow("light touch") << 1.0 << -0.7 << 0.3;
    }
    void steadyPressFeelsTheSpring() {
        QFETCH(double, scale);
        QFETCH(double, turn);
        QFETCH(double, depth);
        HapticSettings settings = Rig::settings();
        settings.mapping.origin = {3.0, -2.0, 5.0};
        settings.mapping.rotation = glm::angleAxis(turn, glm::normalize(glm::dvec3(1, 2, -1)));
        settings.mapping.scale = scale;
        Rig rig(settings, ballTool(), stockOnPart(0, false));
        rig.begin(settings.mapping.toDevice({0, 0, 3}));
        rig.moveTo(settings.mapping.toDevice({0, 0, floorHeight - depth * scale}), 100.0);
        const Sample sample = rig.rest(400);
        // 0.8 of 400 N/m at 1 kHz; the ball's centre stays one radius above the floor, so the tip stays on it.
        const double expected = 0.8 * 400.0 * depth / 1000.0;
        QVERIFY(sample.flags & sampleOnBoundary);
        QVERIFY(std::abs(sample.force.z - expected) <= 0.01 * expected);
        QVERIFY(glm::length(glm::dvec2(sample.force)) <= 0.01 * expected);
        const glm::dvec3 felt = settings.mapping.rotation * rig.step.deviceWrench().force;
        QVERIFY(glm::length(felt - sample.force) < 1e-12);
        QVERIFY(std::abs(sample.proxy.tip.z - floorHeight) <= 1e-3);
    }

    void steadyContactDoesNotTremble() {
        Rig rig(Rig::settings(), ballTool(), stockOnPart(0, false));
        rig.begin({0, 0, 3});
        rig.moveTo({0, 0, floorHeight - 2.0}, 50.0);
        glm::dvec3 before = rig.rest(400).force;
        rig.onTick = [&](const Sample& sample) {
            QVERIFY(glm::length(sample.force - before) <= 1e-9);
            before = sample.force;
        };
        rig.rest(1000);
    }

    void freeMotionIsWithoutForceAndRemovesNothing() {
        QVERIFY(rc::check([] {
            Rig rig;
            const RunAmounts before = rig.volume.amounts();
            rig.onTick = [](const Sample& sample) {
                RC_ASSERT(glm::length(sample.force) <= 0.01);
                RC_ASSERT(sample.cuttingForce == glm::dvec3(0.0));
                RC_ASSERT(removedUnits(sample) == 0u);
                if (sample.proxy.tip.z > voxel) RC_ASSERT(sample.reportedRemoval == 0.0); // it looks a voxel ahead
            };
            rig.begin({0, 0, 5});
            for (int i = 0; i < 5; ++i)
                rig.moveTo({randomNumber(-30, 30), randomNumber(-30, 30), randomNumber(0.01, 20)},
                           randomNumber(5.0, 900.0));
            RC_ASSERT(rig.volume.amounts() == before);
        }));
    }

    void recordsExactlyWhatTheWorkpieceLost() {
        Rig rig;
        const RunAmounts before = rig.volume.amounts();
        std::array<std::uint64_t, 256> recorded{};
        double reported = 0.0;
        rig.onTick = [&](const Sample& sample) {
            for (const RemovedMaterial& removed : sample.removed) recorded[removed.property] += removed.units;
            reported += sample.reportedRemoval;
            QVERIFY(sample.proxy.tip.z >= floorHeight);
        };
        rig.begin({-12, 0, 2});
        rig.moveTo({-12, 0, -4}, 30.0);
        rig.moveTo({12, 3, -4}, 40.0);
        rig.moveTo({10, -3, -14}, 40.0);
        rig.moveTo({-12, -3, -14}, 60.0); // 4 mm into the part
        rig.moveTo({-12, -3, 5}, 60.0);
        const RunAmounts after = rig.volume.amounts();
        QCOMPARE(after.units[2], before.units[2]);
        QCOMPARE(recorded[1], before.units[1] - after.units[1]);
        QCOMPARE(recorded[2], std::uint64_t{0});
        const double removed = static_cast<double>(recorded[1]) * rig.volume.grid().unitVolume();
        QVERIFY(removed > 500.0);
        QVERIFY(std::abs(reported - removed) < 0.05 * removed);
    }

    void startInsideThePartKeepsTheForceOffUntilClear() {
        HapticSettings settings = Rig::settings();
        settings.rampSeconds = 0.2;
        Rig rig(settings);
        const RunAmounts before = rig.volume.amounts();
        rig.onTick = [&](const Sample& sample) {
            if (rig.step.started()) return;
            QCOMPARE(sample.force, glm::dvec3(0.0));
            QVERIFY(sample.flags & sampleForcesOff);
            QVERIFY(rig.field.clearance(sample.proxy.tip) >= 0.0);
        };
        rig.begin({0, 0, floorHeight - 5.0});
        rig.moveTo({5, 0, floorHeight - 0.1}, 20.0);
        QVERIFY(!rig.step.started());
        QVERIFY(rig.volume.amounts() == before);
        // Free of the part: engaged at the hand's position, and forces fade in from zero.
        rig.moveTo({5, 0, floorHeight + 0.05}, 20.0);
        QVERIFY(rig.step.started());
        glm::dvec3 last(0.0);
        rig.onTick = [&](const Sample& sample) {
            QVERIFY(glm::length(sample.force - last) < 0.2);
            last = sample.force;
        };
        rig.moveTo({5, 0, floorHeight - 3.0}, 200.0);
        QVERIFY(glm::length(last) < 0.1);
        rig.rest(400);
        QVERIFY(last.z > 0.9);
    }

    void shankContactBrakesAndNeverDamagesTheWorkpiece() {
        const Tool tool = ballTool(5.0, 12.0); // a shank wider than the flutes, 5 mm above the tip
        Rig rig(Rig::settings(), tool);
        int firstFlagged = -1, tick = 0;
        double handAtFirst = 0.0;
        rig.onTick = [&](const Sample& sample) {
            const bool braking = sample.flags & sampleShankContact;
            if (braking && firstFlagged < 0) {
                firstFlagged = tick;
                handAtFirst = sample.stylusTip.z;
            }
            if (braking) {
                QCOMPARE(removedUnits(sample), std::uint64_t{0});
                QCOMPARE(sample.cuttingForce, glm::dvec3(0.0));
            }
            QVERIFY(shankOverlap(rig.volume, tool, sample.proxy.tip) <= 0.25 * voxel + 1e-6);
            ++tick;
        };
        rig.begin({0.1, 0.2, 3});
        rig.moveTo({0.1, 0.2, -9}, 20.0);
        // The shank's end face meets the top of the stock at a tip of -5 mm; the first quarter of a voxel is ignored.
        QVERIFY(firstFlagged > 0);
        QVERIFY(std::abs(handAtFirst - (-5.0 - 0.25 * voxel)) <= 0.021);
        const Sample held = rig.rest(400);
        QVERIFY(held.flags & sampleShankContact);
        const double expected = std::min(0.32 * (held.proxy.tip.z + 9.0), 0.6 * 4.0);
        QVERIFY(std::abs(held.force.z - expected) <= 0.01 * expected);
        QVERIFY(std::abs(held.proxy.tip.z + 5.125) < 0.03);

        // Moving sideways does not release it, moving up does, and then it cuts again.
        rig.moveTo({4.0, 0.2, -9}, 20.0);
        QCOMPARE(rig.rest(1).proxy.tip.x, 0.1);
        rig.moveTo({4.0, 0.2, -4}, 20.0);
        const RunAmounts before = rig.volume.amounts();
        const Sample free = rig.moveTo({9.0, 0.2, -4}, 20.0);
        QVERIFY(!(free.flags & sampleShankContact));
        QVERIFY(glm::length(free.proxy.tip - glm::dvec3(9.0, 0.2, -4)) < 1e-6);
        QVERIFY(rig.volume.amounts().units[1] < before.units[1]);
    }

    /// A tool with a stationary spindle is held by the part only: not by the stock, nor by what shank and holder would
    /// touch.
    void aStandingSpindleMovesThroughStockAndCutsNothing() {
        HapticSettings settings = Rig::settings();
        settings.cutsOnButton = true;
        Rig rig(settings, ballTool(5.0, 12.0)); // a shank wider than the flutes
        const RunAmounts before = rig.volume.amounts();
        rig.begin({0, 0, 3});
        rig.onTick = [&](const Sample& sample) {
            QVERIFY(sample.flags & sampleSpindleOff);
            QVERIFY(!(sample.flags & sampleShankContact));
            QVERIFY(glm::length(sample.proxy.tip - sample.stylusTip) < 1e-9);
            QCOMPARE(sample.reportedRemoval, 0.0);
            QCOMPARE(sample.cuttingForce, glm::dvec3(0.0));
        };
        rig.moveTo({0, 0, -9}, 200.0);
        rig.moveTo({8, 3, -9}, 200.0);
        rig.onTick = [](const Sample&) {};
        const Sample pressed = rig.moveTo({8, 3, -14}, 200.0);
        QVERIFY(pressed.proxy.tip.z >= floorHeight);
        QVERIFY(pressed.flags & sampleOnBoundary);
        QVERIFY(rig.volume.amounts() == before);

        rig.moveTo({8, 3, -3}, 200.0);
        rig.buttons = 1;
        QVERIFY(!(rig.rest(1).flags & sampleSpindleOff));
        std::uint64_t recorded = 0;
        for (std::size_t i = 0; i < 256; ++i) recorded += i == 0 ? 0 : before.units[i] - rig.volume.amounts().units[i];
        QVERIFY(recorded > 0); // the material within the flutes when the spindle started
        rig.moveTo({2, 3, -3}, 100.0);
        rig.step.settle(); // pending removal becomes visible now
        const std::uint64_t cut = rig.volume.amounts().units[1];
        rig.buttons = 0;
        rig.moveTo({-8, 3, -3}, 100.0);
        QCOMPARE(rig.volume.amounts().units[1], cut);
    }

    /// Everything that a take removed is recorded between two of its samples, whenever the take begins.
    void aTakeBeginsWithoutACut() {
        Rig rig;
        rig.begin({-12, 0, -3});
        rig.moveTo({-2, 0, -3}, 100.0);
        rig.step.releaseSpindle(false);
        rig.moveTo({4, 0, -3}, 100.0);
        rig.step.releaseSpindle(true);
        rig.step.beginTake();
        const Sample first = rig.rest(1);
        QCOMPARE(first.tick, std::uint64_t{0});
        QCOMPARE(first.time, 0.0);
        QCOMPARE(removedUnits(first), std::uint64_t{0});
        QVERIFY(!(first.flags & sampleSpindleOff));
        const Sample second = rig.feed({4.05, 0, -3});
        QCOMPARE(second.tick, std::uint64_t{1});
        QVERIFY(removedUnits(second) > 0);
    }

    void anotherWorkpieceUnderTheToolGivesNoKick() {
        HapticSettings settings = Rig::settings();
        settings.rampSeconds = 0.2;
        Rig rig(settings);
        const VolumeSnapshot whole = rig.volume.snapshot();
        rig.begin({-14, 0, -3});
        rig.moveTo({4, 0, -3}, 50.0);
        rig.volume.restore(whole);
        rig.step.workpieceChanged({});
        QVERIFY(rig.volume.amounts() == whole.amounts());
        glm::dvec3 last(0.0);
        bool first = true;
        rig.onTick = [&](const Sample& sample) {
            if (std::exchange(first, false)) QVERIFY(glm::length(sample.force) < 1e-9);
            QVERIFY(glm::length(sample.force - last) < 0.2);
            last = sample.force;
        };
        rig.moveTo({9, 0, -3}, 50.0);
        QVERIFY(!first);
        QVERIFY(glm::length(last) > 0.0);
    }

    void changedAllowanceGivesNoKick() {
        Rig rig(Rig::settings(), ballTool(), stockOnPart(0, false));
        rig.begin({0, 0, 3});
        rig.moveTo({0, 0, floorHeight - 1.0}, 50.0);
        glm::dvec3 before = rig.rest(400).force;
        double largestChange = 0.0;
        rig.onTick = [&](const Sample& sample) {
            largestChange = std::max(largestChange, glm::length(sample.force - before));
            before = sample.force;
        };
        rig.step.setAllowance(0.5);
        Sample sample = rig.rest(400);
        QVERIFY(sample.proxy.tip.z >= floorHeight + 0.5);
        QVERIFY(sample.proxy.tip.z <= floorHeight + 0.5 + 1e-3);
        QVERIFY(std::abs(before.z - 0.32 * 1.5) < 0.01 * 0.48);
        rig.step.setAllowance(0.1);
        sample = rig.rest(400);
        QVERIFY(sample.proxy.tip.z >= floorHeight + 0.1);
        QVERIFY(sample.proxy.tip.z <= floorHeight + 0.1 + 1e-3);
        QVERIFY2(largestChange <= 0.02, qPrintable(QString::number(largestChange)));
    }

    void withoutMemoryItStopsCuttingAndHolds() {
        // When the stock is milled completely, a small reserve runs out somewhere; it does not matter where.
        Rig rig(Rig::settings(), ballTool(), stockOnPart(400'000));
        std::vector<VolumeSnapshot> held; // as for undo: no memory is given back
        const std::uint64_t whole = rig.volume.amounts().units[1];
        std::uint64_t counted = 0;
        bool full = false;
        rig.onTick = [&](const Sample& sample) {
            if (full) {
                QVERIFY(sample.flags & sampleMemoryFull);
                QCOMPARE(removedUnits(sample), std::uint64_t{0});
            }
            counted += removedUnits(sample);
            // Removal that was counted before may still be pending, and nothing else.
            QVERIFY(whole - rig.volume.amounts().units[1] <= counted);
            full = full || (sample.flags & sampleMemoryFull);
        };
        rig.begin({-15, -15, -2});
        for (int i = 0; i < 200 && !full; ++i) {
            held.push_back(rig.volume.snapshot());
            rig.moveTo({i % 2 == 0 ? 15.0 : -15.0, -15.0 + 0.4 * i, -2.0 - 0.05 * i}, 200.0);
        }
        QVERIFY(full);
        const glm::dvec3 stuck = rig.rest(1).proxy.tip;
        rig.moveTo({stuck.x, stuck.y, stuck.z - 4.0}, 50.0);
        const Sample deeper = rig.rest(200);
        QVERIFY(deeper.proxy.tip.z >= stuck.z - 0.3);
        QVERIFY(deeper.force.z > 1.0);
        rig.moveTo({stuck.x, stuck.y, 8.0}, 50.0);
        QVERIFY(glm::length(rig.rest(1).proxy.tip - glm::dvec3(stuck.x, stuck.y, 8.0)) < 1e-6);
    }
};

BURIN_TEST(TestHapticStep, NoApplication)

} // namespace burin::tst_haptic_step

#include "tst_haptic_step.moc"
