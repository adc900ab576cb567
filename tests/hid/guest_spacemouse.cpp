// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/hid/plugged_mouse.h"

#include <cmath>

namespace burin::test {
namespace {

/// Reads as a loop does, until the condition holds.
template <class Condition>
bool reads(Stylus& stylus, double& time, const Condition& holds) {
    return comesTrue([&] { return holds(stylus.read(time += 0.001)); });
}

void areFoundAndOtherDevicesAreNot() {
    DeviceRegistry registry;
    for (const Error& fault : registry.takeFaults()) throw Unmet(fault.subject + ": " + fault.detail);
    const PluggedMouse mouse(0x046d, 0xc077, mouseDescriptor), cadMouse(0x256f, 0xc650, navigatorDescriptor),
        pro(0x046d, 0xc62b, wirelessDescriptor), first(0x256f, 0xc635, navigatorDescriptor, "A"),
        second(0x256f, 0xc635, navigatorDescriptor, "B");
    const auto found = foundAs(registry, "spacemouse:046d:c62b");
    BURIN_EXPECT(found && found->name == "SpaceMouse Pro" && found->modes.size() == 2);
    BURIN_EXPECT(foundAs(registry, "spacemouse:256f:c635:A"));
    BURIN_EXPECT(foundAs(registry, "spacemouse:256f:c635:B"));
    int mice = 0;
    for (const FoundDevice& device : registry.scan())
        if (device.id.starts_with("spacemouse:")) ++mice;
    BURIN_EXPECT(mice == 3);
}

/// Three axes per report, as SpaceNavigator and SpaceMouse Compact send them. The kernel assigns the id of the former
/// to a driver that accepts real USB devices only, so the device here has the id of the latter.
void compactMovesAndPresses() {
    DeviceRegistry registry;
    PluggedMouse mouse(0x256f, 0xc635, navigatorDescriptor);
    const auto stylus = openedMouse(registry, "spacemouse:256f:c635");
    double time = 0.0;
    mouse.send("01 5e 01 00 00 00 00");
    mouse.send("02 00 00 00 00 00 00");
    mouse.send("03 02 00");
    BURIN_EXPECT(reads(*stylus, time, [](const StylusState& state) {
        return state.valid && state.pose.position.x > 1.0 && state.buttons == 2U;
    }));
    const double x = stylus->read(time).pose.position.x;
    // No more reports arrive: the cap counts as at rest, and the button as pressed.
    for (int i = 0; i < 500; ++i) stylus->read(time += 0.001);
    const StylusState rested = stylus->read(time += 0.001);
    BURIN_EXPECT(rested.pose.position.x <= x + 0.11 * 100.0 && rested.buttons == 2U);
    BURIN_EXPECT(stylus->read(time += 0.001).pose.position.x == rested.pose.position.x);
}

void wirelessMovesAndTellsItsBattery() {
    DeviceRegistry registry;
    PluggedMouse mouse(0x256f, 0xc62e, wirelessDescriptor);
    const auto stylus = openedMouse(registry, "spacemouse:256f:c62e", "position");
    double time = 0.0;
    mouse.send("01 00 00 5e 01 00 00 00 00 00 00 a2 fe");
    mouse.send("17 2a 01");
    BURIN_EXPECT(reads(*stylus, time, [](const StylusState& state) {
        return state.pose.position.y < -5.0 && state.pose.rotation.z > 0.01;
    }));
    BURIN_EXPECT(comesTrue([&] { return stylus->health().batteryShare.has_value(); }));
    BURIN_EXPECT(std::abs(*stylus->health().batteryShare - 0.42) < 1e-9 && stylus->health().charging);
}

void enterpriseHasManyButtons() {
    DeviceRegistry registry;
    PluggedMouse mouse(0x256f, 0xc633, enterpriseDescriptor);
    const auto stylus = openedMouse(registry, "spacemouse:256f:c633");
    double time = 0.0;
    mouse.send("03 01 00 00 40");
    mouse.send("1c 0d 00 00 00 00 00 00 00 00 00 00 00");
    BURIN_EXPECT(reads(*stylus, time, [](const StylusState& state) { return state.buttons == 0x40001001U; }));
    mouse.send("03 00 00 00 00");
    mouse.send("1c 00 00 00 00 00 00 00 00 00 00 00 00");
    BURIN_EXPECT(reads(*stylus, time, [](const StylusState& state) { return state.buttons == 0U; }));
}

void ledShinesWhileItIsOpen() {
    DeviceRegistry registry;
    PluggedMouse mouse(0x256f, 0xc635, navigatorDescriptor);
    auto stylus = openedMouse(registry, "spacemouse:256f:c635");
    BURIN_EXPECT(comesTrue([&] { return mouse.outputs() == std::vector<Report>{{0x04, 0x01}}; }));
    stylus->close();
    BURIN_EXPECT(comesTrue([&] { return mouse.outputs() == std::vector<Report>({{0x04, 0x01}, {0x04, 0x00}}); }));
}

void unpluggedSaysSoAndGoesOn() {
    DeviceRegistry registry;
    auto mouse = std::make_unique<PluggedMouse>(0x256f, 0xc635, navigatorDescriptor, "A");
    const auto stylus = openedMouse(registry, "spacemouse:256f:c635:A");
    double time = 0.0;
    mouse->send("01 5e 01 00 00 00 00");
    mouse->send("03 01 00");
    BURIN_EXPECT(reads(*stylus, time, [](const StylusState& state) { return state.buttons == 1U; }));
    mouse.reset();
    BURIN_EXPECT(reads(*stylus, time, [](const StylusState& state) { return !state.valid && state.buttons == 0U; }));
    const auto fault = stylus->takeFault();
    BURIN_EXPECT(fault && fault->code == ErrorCode::deviceUnplugged && fault->subject == "SpaceMouse Compact");
    const double x = stylus->read(time += 0.001).pose.position.x;
    BURIN_EXPECT(stylus->read(time += 0.001).pose.position.x == x);
    mouse = std::make_unique<PluggedMouse>(0x256f, 0xc635, navigatorDescriptor, "A");
    BURIN_EXPECT(reads(*stylus, time, [](const StylusState& state) { return state.valid; }));
    mouse->send("01 5e 01 00 00 00 00");
    BURIN_EXPECT(reads(*stylus, time, [x](const StylusState& state) { return state.pose.position.x > x; }));
}

} // namespace

std::vector<GuestCheck> spaceMouseChecks() {
    return {{"3D mice are found and other devices are not", areFoundAndOtherDevicesAreNot},
            {"a SpaceMouse Compact moves and presses", compactMovesAndPresses},
            {"a SpaceMouse Wireless moves and tells its battery", wirelessMovesAndTellsItsBattery},
            {"a SpaceMouse Enterprise has many buttons", enterpriseHasManyButtons},
            {"the LED of a 3D mouse shines while it is open", ledShinesWhileItIsOpen},
            {"an unplugged 3D mouse says so and goes on when it is back", unpluggedSaysSoAndGoesOn}};
}

} // namespace burin::test
