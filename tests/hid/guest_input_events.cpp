// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Gamepads and pen tablets: the kernel turns their HID reports into input events, which the plugin reads.
#include "core/base/units.h"
#include "tests/hid/plugged_mouse.h"

#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <filesystem>
#include <unistd.h>

namespace burin::test {
namespace {

constexpr std::uint16_t padVendor = 0x1209, padProduct = 0x0001, tabletProduct = 0x0002;

struct PadReport {
    std::int16_t x = 0, y = 0, rx = 0, ry = 0;
    std::uint8_t z = 0, rz = 0;
    std::uint16_t buttons = 0;
};

Report bytesOf(const PadReport& pad) {
    Report report;
    const auto word = [&report](int value) {
        report.push_back(static_cast<std::uint8_t>(value & 0xff));
        report.push_back(static_cast<std::uint8_t>(value >> 8 & 0xff));
    };
    for (const int value : {pad.x, pad.y, pad.rx, pad.ry}) word(value);
    report.push_back(pad.z);
    report.push_back(pad.rz);
    word(pad.buttons);
    return report;
}

struct PenReport {
    std::uint8_t flags = 0; ///< tip, first and second button of the barrel, in range
    int x = 0, y = 0;       ///< 0.01 mm
    int pressure = 0;
    std::int8_t tiltX = 0, tiltY = 0; ///< degrees
};
constexpr std::uint8_t tip = 1, barrel = 2, inRange = 8;

Report bytesOf(const PenReport& pen) {
    Report report{pen.flags};
    for (const int value : {pen.x, pen.y})
        for (const int shift : {0, 8, 16, 24}) report.push_back(static_cast<std::uint8_t>(value >> shift & 0xff));
    for (const int shift : {0, 8}) report.push_back(static_cast<std::uint8_t>(pen.pressure >> shift & 0xff));
    report.push_back(static_cast<std::uint8_t>(pen.tiltX));
    report.push_back(static_cast<std::uint8_t>(pen.tiltY));
    return report;
}

/// Reads as a loop does, until the condition holds.
template <class Condition>
bool reads(Stylus& stylus, double& time, const Condition& holds) {
    return comesTrue([&] { return holds(stylus.read(time += 0.001)); });
}

void areFound() {
    DeviceRegistry registry;
    const PluggedMouse mouse(0x046d, 0xc077, mouseDescriptor), pad(padVendor, padProduct, gamepadDescriptor),
        twin(padVendor, padProduct, gamepadDescriptor), tablet(padVendor, tabletProduct, tabletDescriptor, "T1");
    const auto found = foundAs(registry, "input:1209:0001");
    BURIN_EXPECT(found && found->modes.size() == 2);
    BURIN_EXPECT(foundAs(registry, "input:1209:0001:2"));
    const auto pen = foundAs(registry, "input:1209:0002:T1");
    BURIN_EXPECT(pen && pen->modes.empty());
    int count = 0;
    for (const FoundDevice& device : registry.scan())
        if (device.id.starts_with("input:")) ++count;
    BURIN_EXPECT(count == 3);
}

void sticksMoveTheTool() {
    DeviceRegistry registry;
    PluggedMouse pad(padVendor, padProduct, gamepadDescriptor);
    const auto stylus = openedMouse(registry, "input:1209:0001");
    BURIN_EXPECT(stylus->description().buttons == 12);
    double time = 0.0;
    pad.send(bytesOf(PadReport{.x = 32767, .buttons = 1}));
    BURIN_EXPECT(reads(*stylus, time, [](const StylusState& state) {
        return state.valid && state.pose.position.x > 5.0 && state.pose.position.y == 0.0 && state.buttons == 1U;
    }));
    pad.send(bytesOf(PadReport{.y = 32767})); // towards the user
    BURIN_EXPECT(reads(*stylus, time, [](const StylusState& state) { return state.pose.position.y < -5.0; }));
    pad.send(bytesOf(PadReport{.rz = 255})); // the right trigger presses
    BURIN_EXPECT(reads(*stylus, time, [](const StylusState& state) { return state.pose.position.z < -5.0; }));
    pad.send(bytesOf(PadReport{.ry = -32768})); // the right stick lifts
    BURIN_EXPECT(reads(*stylus, time, [](const StylusState& state) { return state.pose.position.z > 5.0; }));
    pad.send(bytesOf(PadReport{}));
    BURIN_EXPECT(reads(*stylus, time, [](const StylusState& state) { return state.buttons == 0U; }));
    const glm::dvec3 rested = stylus->read(time += 0.001).pose.position;
    for (int i = 0; i < 100; ++i) BURIN_EXPECT(stylus->read(time += 0.001).pose.position == rested);
}

void aPenIsWhereItIs() {
    DeviceRegistry registry;
    PluggedMouse tablet(padVendor, tabletProduct, tabletDescriptor);
    const auto stylus = openedMouse(registry, "input:1209:0002");
    const StylusDescription description = stylus->description();
    BURIN_EXPECT(std::abs(description.workspaceRadius.value - std::hypot(150.0, 100.0)) < 0.1);
    BURIN_EXPECT(description.sensed.rotations == 2);
    double time = 0.0;
    const auto isAt = [](const glm::dvec3& place) {
        return [place](const StylusState& state) { return glm::distance(state.pose.position, place) < 0.05; };
    };
    // 200 mm from the left edge and 50 from the far one: 50 to the right of the centre, 50 away from it.
    tablet.send(bytesOf(PenReport{inRange, 20000, 5000}));
    BURIN_EXPECT(reads(*stylus, time, isAt({50.0, 50.0, 5.0})));
    tablet.send(bytesOf(PenReport{inRange | tip, 20000, 5000, 1024, 30, 0}));
    BURIN_EXPECT(reads(*stylus, time, isAt({50.0, 50.0, -10.0 * 1024.0 / 2047.0})));
    BURIN_EXPECT(reads(*stylus, time, [](const StylusState& state) {
        const glm::dvec3 axis = state.pose.rotation * glm::dvec3(0.0, 0.0, 1.0);
        return state.buttons == 1U && std::abs(axis.x - 0.5) < 0.01 && std::abs(axis.y) < 0.01;
    }));
    tablet.send(bytesOf(PenReport{inRange | tip | barrel, 20000, 5000, 1024, 30, 0}));
    BURIN_EXPECT(reads(*stylus, time, [](const StylusState& state) { return state.buttons == 3U; }));
    // The pen is taken away: the tool is lifted where it was.
    tablet.send(bytesOf(PenReport{0, 20000, 5000, 0}));
    BURIN_EXPECT(reads(*stylus, time, isAt({50.0, 50.0, 5.0})));
    BURIN_EXPECT(stylus->read(time += 0.001).buttons == 0U && stylus->read(time += 0.001).valid);
}

void anUnpluggedTabletGoesOn() {
    DeviceRegistry registry;
    auto tablet = std::make_unique<PluggedMouse>(padVendor, tabletProduct, tabletDescriptor, "T1");
    const auto stylus = openedMouse(registry, "input:1209:0002:T1");
    double time = 0.0;
    tablet->send(bytesOf(PenReport{inRange | tip, 20000, 5000, 2047}));
    BURIN_EXPECT(reads(*stylus, time, [](const StylusState& state) { return state.buttons == 1U; }));
    tablet.reset();
    BURIN_EXPECT(reads(*stylus, time, [](const StylusState& state) { return !state.valid && state.buttons == 0U; }));
    const auto fault = stylus->takeFault();
    BURIN_EXPECT(fault && fault->code == ErrorCode::deviceUnplugged);
    tablet = std::make_unique<PluggedMouse>(padVendor, tabletProduct, tabletDescriptor, "T1");
    BURIN_EXPECT(reads(*stylus, time, [](const StylusState& state) { return state.valid; }));
    tablet->send(bytesOf(PenReport{inRange, 10000, 5000}));
    BURIN_EXPECT(reads(*stylus, time, [](const StylusState& state) { return state.pose.position.x < -45.0; }));
}

void whoMayNotReadIsTold() {
    DeviceRegistry registry;
    const PluggedMouse tablet(padVendor, tabletProduct, tabletDescriptor);
    BURIN_EXPECT(foundAs(registry, "input:1209:0002"));
    for (const auto& node : std::filesystem::directory_iterator("/dev/input"))
        std::filesystem::permissions(node.path(), std::filesystem::perms::none);
    BURIN_EXPECT(seteuid(65534) == 0);
    const auto made = registry.make("input:1209:0002", {});
    BURIN_EXPECT(seteuid(0) == 0);
    BURIN_EXPECT(!made && made.error().code == ErrorCode::deviceNotAllowed);
}

} // namespace

std::vector<GuestCheck> inputEventChecks() {
    return {{"gamepads and tablets are found", areFound},
            {"the sticks of a gamepad move the tool", sticksMoveTheTool},
            {"a pen is where it is, as deep as it is pressed", aPenIsWhereItIs},
            {"an unplugged tablet says so and goes on when it is back", anUnpluggedTabletGoesOn},
            {"who may not read a tablet is told", whoMayNotReadIsTold}};
}

} // namespace burin::test
