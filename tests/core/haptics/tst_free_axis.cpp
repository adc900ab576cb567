// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/contact.h"
#include "core/haptics/boundary/mesh_boundary.h"
#include "core/haptics/boundary/pose_vector.h"
#include "core/haptics/force/turn_coupling.h"
#include "core/haptics/haptic_step.h"
#include "tests/core/geometry/shapes.h"
#include "tests/core/haptics/haptic_rig.h"
#include "tests/oracles/allocation_count.h"
#include "tests/test_program.h"

#include <QtTest>

#include <random>

namespace burin::tst_free_axis {

using namespace burin::test;

namespace {

StylusDescription torqueStylus() {
    StylusDescription stylus = desktopStylus();
    stylus.actuated = {3, 3};
    stylus.maximumTorque = {180.0, "made up"};
    stylus.maximumTurningStiffness = {20.0, "made up"};
    return stylus;
}

glm::dvec3 tilted(double angle) {
    return {std::sin(angle), 0.0, std::cos(angle)};
}

/// A reading of a stylus whose pen points in a direction.
StylusState reading(const glm::dvec3& tip, const glm::dvec3& axis) {
    StylusState state;
    state.pose.position = tip;
    const glm::dvec3 turn = turnBetween({0, 0, 1}, axis);
    const double angle = glm::length(turn);
    if (angle > 0.0) state.pose.rotation = glm::angleAxis(angle, turn / angle);
    state.valid = true;
    return state;
}

/// A shank wider than the flutes, and a holder.
Tool reachingTool() {
    Tool tool = ballTool(5.0, 8.0);
    tool.cutter.stickOut = 25.0;
    tool.cutter.holder = {{20.0, 20.0, 15.0}};
    return tool;
}

/// The rig's stock on its part, milled with a free axis.
struct FreeRig {
    explicit FreeRig(const StylusDescription& stylus = desktopStylus(), const Tool& tool = ballTool())
        : volume(stockOnPart())
        , step(volume,
               BoundaryLayers(std::make_unique<MeshBoundary>(
                   std::make_shared<const MeshDistance>(shapes::box({-20, -20, -20}, {20, 20, floorHeight})),
                   pieces(tool.cutter), voxel)),
               tool, settings(stylus)) {}

    static HapticSettings settings(const StylusDescription& stylus) {
        HapticSettings settings;
        settings.stylus = stylus;
        settings.axis.free = true;
        settings.rampSeconds = 0.0;
        return settings;
    }
    Sample feed(const glm::dvec3& tip, const glm::dvec3& axis) { return step.advance(reading(tip, axis), period); }
    /// Moves in a straight line, 0.2 mm per tick.
    Sample move(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& axis) {
        const int ticks = static_cast<int>(std::ceil(glm::length(to - from) / 0.2));
        Sample last;
        for (int i = 1; i <= ticks; ++i) last = feed(glm::mix(from, to, static_cast<double>(i) / ticks), axis);
        return last;
    }
    Sample rest(const glm::dvec3& tip, const glm::dvec3& axis, int ticks) {
        Sample last;
        for (int i = 0; i < ticks; ++i) last = feed(tip, axis);
        return last;
    }

    RunVolume volume;
    HapticStep step;
};

bool removedAny(const Sample& sample) {
    return std::any_of(sample.removed.begin(), sample.removed.end(),
                       [](const RemovedMaterial& removed) { return removed.units > 0; });
}

} // namespace

class TestFreeAxis : public QObject {
    Q_OBJECT
private slots:
    void theToolTakesTheStylusAxis() {
        FreeRig rig;
        const Sample first = rig.feed({0, 0, 15}, tilted(0.4));
        QVERIFY(glm::length(first.proxy.axis - tilted(0.4)) < 1e-12);
        // A jump of the hand is followed at 2 rad/s.
        const Sample later = rig.rest({3, 0, 15}, tilted(-0.3), 500);
        QVERIFY(glm::length(later.proxy.axis - tilted(-0.3)) < 1e-9);
        QVERIFY(glm::length(later.force) < 0.01);
        QVERIFY(!(later.flags & sampleAxisHeld));
    }

    void aStandingAxisIgnoresTheStylusAxis() {
        Rig rig;
        rig.feed({0, 0, 15});
        const Sample sample = rig.step.advance(reading({0, 0, 15}, tilted(0.8)), period);
        QCOMPARE(sample.proxy.axis, glm::dvec3(0.0, 0.0, 1.0));
        QCOMPARE(rig.step.deviceWrench().torque, glm::dvec3(0.0));
    }

    void itCutsTiltedAndStaysOutOfThePart() {
        FreeRig rig(desktopStylus(), ballTool(30.0));
        rig.feed({0, 0, 15}, tilted(0.5));
        double deepest = 1e300;
        bool cut = false;
        for (int tick = 0; tick < 800; ++tick) {
            const double t = tick * 0.001;
            const Sample sample =
                rig.feed({10.0 * std::sin(3.0 * t), 0.0, 15.0 - 40.0 * t}, tilted(0.5 * std::cos(5.0 * t)));
            cut = cut || removedAny(sample);
            // A ball: its centre 3 mm up the axis.
            deepest = std::min(deepest, (sample.proxy.tip + 3.0 * sample.proxy.axis).z - 3.0 - floorHeight);
        }
        QVERIFY(cut);
        QVERIFY2(deepest >= 0.0 && deepest < 0.01, qPrintable(QString::number(deepest)));
    }

    void aStartInsideThePartKeepsForcesOffAndThrowsNothingOut() {
        FreeRig rig;
        rig.step.releaseSpindle(false); // only the part limits the tool
        for (int tick = 0; tick < 50; ++tick) {
            const Sample sample = rig.feed({0, 0, floorHeight - 5.0}, tilted(0.3));
            QCOMPARE(sample.force, glm::dvec3(0.0));
            QVERIFY(sample.flags & sampleForcesOff);
            QVERIFY(!removedAny(sample));
            QVERIFY(!rig.step.started());
        }
        for (int tick = 0; tick < 100; ++tick) { // once pulled out, it starts where it becomes free of the part
            const Sample sample = rig.feed({0, 0, floorHeight - 5.0 + 0.1 * tick}, tilted(0.3));
            QVERIFY(glm::length(sample.force) < 0.01);
        }
        QVERIFY(rig.step.started());
    }

    void shankAndHolderBrakeWithinTwoTicksAtAnyTiltAndNothingIsCutMeanwhile() {
        const Tool tool = reachingTool();
        const std::vector<RevolvedPiece> whole = pieces(tool.cutter);
        const std::size_t flutes = flutePieces(tool.cutter).size();
        for (const StylusDescription& stylus : {desktopStylus(), torqueStylus()}) {
            FreeRig rig(stylus, tool);
            std::mt19937 engine(7);
            std::uniform_real_distribution<double> number(-1.0, 1.0);
            glm::dvec3 tip(0, 0, 12), axis(0, 0, 1), tipGoal = tip, axisGoal = axis;
            int contacts = 0, unbraked = 0, worst = 0, onsets = 0, tiltedContacts = 0;
            bool follows = false;
            for (int tick = 0; tick < 6000; ++tick) {
                if (tick % 150 == 0) {
                    tipGoal = {15.0 * number(engine), 15.0 * number(engine), 6.0 * number(engine)}; // clear of the part
                    axisGoal = glm::normalize(glm::dvec3(number(engine), number(engine), 1.0));
                }
                tip += clampLength(tipGoal - tip, 0.15);
                axis = turned(axis, clampLength(turnBetween(axis, axisGoal), 0.004));
                const Sample sample = rig.feed(tip, axis);
                if (!rig.step.started()) continue;
                const bool braked = (sample.flags & sampleShankContact) != 0;
                QVERIFY(!(braked && removedAny(sample)));
                // At the tool's pose, shank and holder do not touch, whatever pose the hand requests.
                rig.step.settle();
                QVERIFY(!shankContact(rig.volume, whole, flutes, sample.proxy).touches);
                // The tool was at the hand's pose, and the hand now drives the shank in.
                const bool driven = shankContact(rig.volume, whole, flutes, {tip, axis}).touches;
                if (follows && driven) ++onsets;
                unbraked = driven && !braked && (follows || unbraked > 0) ? unbraked + 1 : 0;
                worst = std::max(worst, unbraked);
                follows = glm::length(tip - sample.proxy.tip) < 1e-3 && glm::length(axis - sample.proxy.axis) < 1e-3;
                if (braked) {
                    ++contacts;
                    if (sample.proxy.axis.z < 0.95) ++tiltedContacts;
                    QVERIFY(rig.step.shankContact().touches);
                }
            }
            QVERIFY2(contacts > 100 && tiltedContacts > 20 && onsets > 3, qPrintable(QString::number(onsets)));
            QVERIFY2(worst < 2, qPrintable(QString::number(worst)));
        }
    }

    void aHandWithTorqueFeelsTheAxisThatThePartHolds() {
        Tool flat = ballTool();
        flat.cutter.type = CutterType::flat;
        flat.cutter.cornerRadius = 0.0;
        FreeRig rig(torqueStylus(), flat);
        rig.step.releaseSpindle(false); // only the part limits the tool
        rig.feed({0, 0, 15}, tilted(0.0));
        rig.move({0, 0, 15}, {0, 0, floorHeight - 5.0}, tilted(0.0));
        const Sample pressed = rig.rest({0, 0, floorHeight - 5.0}, tilted(0.3), 300);
        // Pressed flat on the floor the tool tends to stay upright: the hand is turned back, about +y to -x.
        const glm::dvec3 torque = rig.step.deviceWrench().torque;
        const glm::dvec3 behind = turnBetween(tilted(0.3), pressed.proxy.axis);
        const TurnCoupling coupling(FreeRig::settings(torqueStylus()));
        QVERIFY(glm::length(behind) > 0.05);
        QVERIFY(torque.y < -1.0);
        QVERIFY(glm::length(torque - clampLength(coupling.stiffness() * behind, coupling.maximum())) < 1e-6);
        QVERIFY(glm::length(torque) <= coupling.maximum() + 1e-9);
        QVERIFY(!(pressed.flags & sampleAxisHeld)); // the hand feels the torque
        QCOMPARE(pressed.torque, torque);           // and it is recorded
        // Free again, there is no torque.
        rig.move({0, 0, floorHeight - 5.0}, {0, 0, 15}, tilted(0.3));
        rig.rest({0, 0, 15}, tilted(0.3), 100);
        QVERIFY(glm::length(rig.step.deviceWrench().torque) < 1e-3);
        // A fault ends the torque at once.
        rig.move({0, 0, 15}, {0, 0, floorHeight - 5.0}, tilted(0.3));
        QVERIFY(glm::length(rig.step.deviceWrench().torque) > 1.0);
        StylusState silent;
        QCOMPARE(rig.step.advance(silent, period).torque, glm::dvec3(0.0));
        QCOMPARE(rig.step.deviceWrench().torque, glm::dvec3(0.0));
    }

    void aTickWithAFreeAxisAllocatesNothing() {
        FreeRig rig;
        rig.feed({0, 0, 15}, tilted(0.2));
        const std::size_t before = allocationCount.load();
        for (int tick = 0; tick < 500; ++tick)
            rig.feed({5.0 * std::sin(0.01 * tick), 0, 15.0 - 0.06 * tick}, tilted(0.5 * std::sin(0.02 * tick)));
        QCOMPARE(allocationCount.load(), before);
    }
};

BURIN_TEST(TestFreeAxis, NoApplication)

} // namespace burin::tst_free_axis

#include "tst_free_axis.moc"
