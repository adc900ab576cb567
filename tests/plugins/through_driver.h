// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/operator/hostile_stylus.h"
#include "tests/core/haptics/haptic_rig.h"
#include "tests/core/haptics/hostile_rig.h"
#include "tests/core/haptics/replayed_session.h"
#include "tests/oracles/simulated_handle.h"

#include <QString>
#include <QTemporaryDir>

#include <chrono>
#include <cmath>
#include <functional>
#include <thread>

namespace burin::test {

/// One tick of a device together with the loop behind it. @param reading  position of the handle, mm, Burin's device
/// frame; not finite for an invalid reading @param buttons  of the handle @return  force of the device's motors, N, in
/// the same frame
using DeviceTick = std::function<glm::dvec3(const glm::dvec3& reading, std::uint32_t buttons)>;

/// The haptic step as called by a driver, with a period of its own: time in these tests is counted in ticks.
class StepClient final : public StylusClient {
public:
    explicit StepClient(HapticStep& step) : step_(step) {}
    Wrench tick(const StylusState& state) noexcept override {
        (void)step_.advance(state, period);
        return step_.deviceWrench();
    }

private:
    HapticStep& step_;
};

/// The energy that a device gives to a hand per contact, J, while the hand moves into the part's floor and out again.
inline double energyPerContact(const SimulatedGrip& grip, const SimulatedMechanism& mechanism, const DeviceTick& tick) {
    constexpr int contacts = 10;
    SimulatedHandle handle(grip, mechanism, {0.0, 0.0, floorHeight + 2.0});
    for (int i = 0; i < contacts * 1000; ++i) {
        const glm::dvec3 force = tick(handle.reading(), 0);
        const double request = floorHeight + 2.0 * std::cos(2.0 * pi * i * period); // one contact a second
        handle.hold(force, {0.0, 0.0, request}, glm::dvec3(0.0), period);
    }
    return handle.energy() / contacts;
}

/// Sends hostile readings through a device. Whatever they are, forces stay finite and within the given share of the
/// device's maximum, and there is no force after an invalid reading. Returns an empty string if that holds.
inline QString hostileReadings(const StylusDescription& stylus, double share, int ticks, const DeviceTick& tick) {
    HostileSettings settings = strayingInTheStock(20261129);
    settings.stylus = stylus;
    HostileStylus hostile(settings);
    const double largest = share * stylus.maximumForce.value;
    int pushed = 0;
    for (int i = 0; i < ticks; ++i) {
        const HostileStylus::Tick hand = hostile.next();
        const bool gone = !hand.state.valid;
        const glm::dvec3 place = gone ? glm::dvec3(NAN) : hand.state.pose.position;
        const glm::dvec3 force = tick(place, hand.state.buttons);
        Wrench felt;
        felt.force = force;
        hostile.write(felt);
        if (!isFinite(force)) return QString("tick %1: not finite").arg(i);
        if (glm::length(force) > largest + 1e-9) return QString("tick %1: %2 N").arg(i).arg(glm::length(force));
        if (!isFinite(place) && glm::length(force) > 0.0) return QString("tick %1: force after no reading").arg(i);
        pushed += glm::length(force) > 0.0 ? 1 : 0;
    }
    return pushed * 10 > ticks ? QString() : QString("pushed in %1 ticks only").arg(pushed);
}

/// Records a session with a device whose handle mills through the stock onto the part, and replays its trace. Returns
/// an empty string if the replay is the same to the bit and the session contained the expected events.
/// @param moveTo  moves the handle to a position, mm, Burin's device frame; called once a millisecond on a separate
/// thread
inline QString sessionThroughDriver(const StylusHandle& stylus, const std::function<void(const glm::dvec3&)>& moveTo) {
    const QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath("trace.csv").toStdString();
    HapticSettings settings;
    settings.stylus = stylus.device().description();
    settings.rampSeconds = 0.05;
    settings.mapping.origin = {0.0, 0.0, 5.0}; // above the stock
    RecordedSession original;
    {
        const std::jthread mover([&](const std::stop_token& stop) {
            for (int i = 0; !stop.stop_requested(); ++i) {
                const double time = 0.001 * i;
                moveTo({6.0 * std::sin(8.0 * time), 6.0 * (1.0 - std::cos(8.0 * time)),
                        -std::min(60.0 * std::max(0.0, time - 0.05), 17.0)});
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
        });
        original = recordSession(stylus, settings, file, 1.2);
    }
    const std::string difference = differenceOf(original, replaySession(settings, file));
    if (!difference.empty()) return QString::fromStdString(difference);
    const SessionEvents events = eventsOf(original.samples);
    if (events.cut > 50 && events.held > 20 && events.felt > 20) return {};
    return QString("%1 ticks cut, %2 held, %3 felt").arg(events.cut).arg(events.held).arg(events.felt);
}

} // namespace burin::test
