// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// Force feedback through the kernel's own interface: the plugin uploads and plays effects, a device of /dev/uinput
// renders them.
#include "core/device/device_thread.h"
#include "tests/hid/plugged_mouse.h"
#include "tests/hid/uinput_device.h"

#include <csignal>
#include <filesystem>
#include <sys/wait.h>
#include <unistd.h>

namespace burin::test {
namespace {

const UinputIdentity stickIdentity{
    "Stick with force",       0x1209,         0x0010,
    {BTN_TRIGGER, BTN_THUMB}, {ABS_X, ABS_Y}, {FF_CONSTANT, FF_SPRING, FF_DAMPER, FF_GAIN, FF_AUTOCENTER}};
const UinputIdentity padIdentity{
    "Pad with motors", 0x1209, 0x0011, {BTN_SOUTH, BTN_EAST}, {ABS_X, ABS_Y, ABS_RX, ABS_RY}, {FF_RUMBLE, FF_GAIN}};
constexpr const char *stickId = "input:1209:0010", *padId = "input:1209:0011";

Wrench pushing(const glm::dvec3& force, double ceiling) {
    Wrench wrench;
    wrench.assist.force = force;
    wrench.assist.contact = 0.25;
    wrench.assist.load = 0.5;
    wrench.assist.ceiling = ceiling;
    return wrench;
}

/// Ticks as a loop does, until the condition holds.
template <class Condition>
bool ticksUntil(Stylus& stylus, const Wrench& wrench, const Condition& holds) {
    return comesTrue([&] {
        stylus.read(steadySeconds());
        stylus.write(wrench);
        return holds();
    });
}

bool levelIs(UinputDevice& device, int direction, int level) {
    const auto effect = device.rendered(FF_CONSTANT);
    return effect && effect->direction == direction && effect->u.constant.level == level;
}

void aStickPushes() {
    DeviceRegistry registry;
    UinputDevice device(stickIdentity);
    const auto stylus = openedMouse(registry, stickId);
    const AssistAbilities assist = stylus->description().assist;
    BURIN_EXPECT(assist.forceAxes == 2 && assist.works() && !stylus->description().hasMotors());
    // round(0.5 · 32767) to the right, round(0.25 · 32767) away, and to the left no more than round(0.6 · 32767).
    BURIN_EXPECT(ticksUntil(*stylus, pushing({0.5, 0.0, 0.0}, 0.6), [&] { return levelIs(device, 0xc000, 16384); }));
    BURIN_EXPECT(ticksUntil(*stylus, pushing({0.0, 0.25, 0.0}, 0.6), [&] { return levelIs(device, 0x8000, 8192); }));
    BURIN_EXPECT(ticksUntil(*stylus, pushing({-9.0, 0.0, 0.0}, 0.6), [&] { return levelIs(device, 0x4000, 19660); }));
    const auto effect = device.rendered(FF_CONSTANT);
    BURIN_EXPECT(effect && effect->replay.length > 0 && effect->replay.length <= 100);
    const auto spring = device.rendered(FF_SPRING), damper = device.rendered(FF_DAMPER);
    BURIN_EXPECT(spring && damper && spring->u.condition[1].right_saturation == 39321); // 0.6
    BURIN_EXPECT(device.values(FF_GAIN) == std::vector<int>{0xffff});
    BURIN_EXPECT(device.values(FF_AUTOCENTER) == std::vector<int>{0});
    // The tick still reads: sticks and buttons arrive while effects are written.
    device.send(EV_KEY, BTN_TRIGGER, 1);
    BURIN_EXPECT(comesTrue([&] { return stylus->read(steadySeconds()).buttons == 1U; }));
    stylus->close();
    BURIN_EXPECT(comesTrue([&] { return device.kept() == 0; }));
    BURIN_EXPECT((device.values(FF_AUTOCENTER) == std::vector<int>{0, 0xffff}));
}

void aPadVibrates() {
    DeviceRegistry registry;
    UinputDevice device(padIdentity);
    const auto stylus = openedMouse(registry, padId);
    BURIN_EXPECT(stylus->description().assist.rumble && stylus->description().assist.forceAxes == 0);
    BURIN_EXPECT(ticksUntil(*stylus, pushing({0.5, 0.0, 0.0}, 0.4), [&] {
        const auto effect = device.rendered(FF_RUMBLE);
        return effect && effect->u.rumble.strong_magnitude == 16384 && effect->u.rumble.weak_magnitude == 26214;
    }));
    // The loop stands: silence within 100 ms after what is stale was noticed, without a call of the owner.
    const double stopped = steadySeconds();
    BURIN_EXPECT(comesTrue([&] { return !device.rendered(FF_RUMBLE); }));
    tellFigure("vibration ends after the last tick", 1e3 * (steadySeconds() - stopped), "ms");
    BURIN_EXPECT(ticksUntil(*stylus, pushing({}, 0.4), [&] { return device.rendered(FF_RUMBLE).has_value(); }));
    stylus->cutMotors();
    BURIN_EXPECT(comesTrue([&] { return !device.rendered(FF_RUMBLE); }));
    BURIN_EXPECT(ticksUntil(*stylus, pushing({}, 0.4), [&] { return device.rendered(FF_RUMBLE).has_value(); }));
}

} // namespace

int pushForEver() {
    DeviceRegistry registry;
    const auto made = registry.make(stickId);
    if (!made) return 1;
    Stylus& stylus = *std::get<std::unique_ptr<Stylus>>(*made);
    if (!stylus.open()) return 1;
    for (;;) {
        stylus.read(steadySeconds());
        stylus.write(pushing({0.5, 0.0, 0.0}, 0.6));
        usleep(1000);
    }
}

namespace {

/// A process that is frozen renews nothing: the device ends its effects. One that is killed leaves no effect behind.
void aHostThatHangsOrDiesPushesNobody() {
    UinputDevice device(stickIdentity);
    {
        DeviceRegistry registry;
        BURIN_EXPECT(foundAs(registry, stickId));
    }
    const pid_t child = fork();
    if (child == 0) {
        execl("/proc/self/exe", "program", "push", nullptr);
        _exit(1);
    }
    const bool pushes = comesTrue([&] { return device.rendered(FF_CONSTANT).has_value(); });
    kill(child, SIGSTOP);
    const double stopped = steadySeconds();
    const bool ends = comesTrue([&] { return !device.rendered(FF_CONSTANT) && !device.rendered(FF_SPRING); });
    const double took = steadySeconds() - stopped;
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    tellFigure("force ends after the process froze", 1e3 * took, "ms");
    BURIN_EXPECT(pushes && ends); // nothing but the device could end it
    BURIN_EXPECT(comesTrue([&] { return device.kept() == 0; }));
}

void anUnpluggedStickGoesOnPushing() {
    DeviceRegistry registry;
    auto device = std::make_unique<UinputDevice>(stickIdentity);
    const auto stylus = openedMouse(registry, stickId);
    const Wrench wrench = pushing({0.5, 0.0, 0.0}, 0.6);
    BURIN_EXPECT(ticksUntil(*stylus, wrench, [&] { return levelIs(*device, 0xc000, 16384); }));
    device.reset();
    BURIN_EXPECT(comesTrue([&] { return !stylus->read(steadySeconds()).valid; }));
    const auto fault = stylus->takeFault();
    BURIN_EXPECT(fault && fault->code == ErrorCode::deviceUnplugged && !stylus->takeFault());
    device = std::make_unique<UinputDevice>(stickIdentity);
    BURIN_EXPECT(ticksUntil(*stylus, wrench, [&] { return levelIs(*device, 0xc000, 16384); }));
    BURIN_EXPECT(!stylus->takeFault());
}

/// Reading is allowed, writing is not: the tool moves, and it is reported why nothing pushes.
void whoMayOnlyReadAPadIsTold() {
    DeviceRegistry registry;
    const UinputDevice device(padIdentity);
    BURIN_EXPECT(foundAs(registry, padId));
    using std::filesystem::perms;
    for (const auto& node : std::filesystem::directory_iterator("/dev/input"))
        std::filesystem::permissions(node.path(), perms::group_read | perms::others_read);
    BURIN_EXPECT(setresuid(65534, 65534, 0) == 0); // access() asks for the real one
    const auto made = registry.make(padId);
    const bool opened = made && std::get<std::unique_ptr<Stylus>>(*made)->open().hasValue();
    BURIN_EXPECT(setresuid(0, 0, 0) == 0);
    BURIN_EXPECT(opened);
    Stylus& stylus = *std::get<std::unique_ptr<Stylus>>(*made);
    BURIN_EXPECT(stylus.description().assist.rumble && !stylus.description().assist.works());
    const auto fault = stylus.takeFault();
    BURIN_EXPECT(fault && fault->code == ErrorCode::deviceAssistDenied && fault->place.starts_with("/dev/input/"));
}

} // namespace

std::vector<GuestCheck> forceFeedbackChecks() {
    return {{"a stick pushes as it is asked to", aStickPushes},
            {"a pad vibrates as it is asked to", aPadVibrates},
            {"a host that hangs or dies pushes nobody", aHostThatHangsOrDiesPushesNobody},
            {"an unplugged stick pushes again when it is back", anUnpluggedStickGoesOnPushing},
            {"who may only read a pad is told", whoMayOnlyReadAPadIsTold}};
}

} // namespace burin::test
