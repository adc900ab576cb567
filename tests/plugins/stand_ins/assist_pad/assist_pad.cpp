// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// A plugin with a gamepad that vibrates, and a hand that presses it down, in place of the system's input devices. What
// it was asked to show is written to the file $BURIN_STAND_IN_PAD_LOG when it is closed: the greatest contact, load,
// push and ceiling.
#include "core/device/device_driver.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <utility>

namespace {

using namespace burin;

class PressedPad final : public Stylus {
public:
    ~PressedPad() override { close(); }
    StylusDescription description() const override {
        StylusDescription description;
        description.name = "Stand-in pad";
        description.buttons = 2;
        description.workspaceRadius = {60.0, "made up"};
        description.assist.rumble = true;
        return description;
    }
    Result<void> open() override {
        opened_ = true;
        return {};
    }
    void close() noexcept override {
        const char* const log = std::getenv("BURIN_STAND_IN_PAD_LOG");
        if (!std::exchange(opened_, false) || log == nullptr) return;
        std::ofstream(log) << shown_.contact << ' ' << shown_.load << ' ' << shown_.force.x << ' ' << shown_.ceiling
                           << '\n';
    }
    /// Down, then it stays; the first button is released for the first half second.
    StylusState read(double time) noexcept override {
        StylusState state;
        state.time = time;
        state.pose.position = {0.0, 0.0, std::max(-50.0, 50.0 - 60.0 * time)};
        state.buttons = time > 0.5 ? 1U : 0U;
        state.valid = true;
        return state;
    }
    void write(const Wrench& wrench) noexcept override {
        shown_.contact = std::max(shown_.contact, wrench.assist.contact);
        shown_.load = std::max(shown_.load, wrench.assist.load);
        shown_.force.x = std::max(shown_.force.x, glm::length(wrench.assist.force));
        shown_.ceiling = std::max(shown_.ceiling, wrench.assist.ceiling);
    }

private:
    bool opened_ = false;
    Assist shown_;
};

class PadDriver final : public DeviceDriver {
public:
    std::vector<FoundDevice> find() override { return {{"pad", "Stand-in pad", {}}}; }
    Result<AnyStylus> make(const std::string& id, const std::string& /*mode*/) override {
        if (id != "pad") return Error{ErrorCode::deviceNotFound, id, {}, {}};
        return AnyStylus(std::unique_ptr<Stylus>(std::make_unique<PressedPad>()));
    }
};

std::unique_ptr<DeviceDriver> makePadDriver(DeviceHost& /*host*/) {
    return std::make_unique<PadDriver>();
}

} // namespace

BURIN_DEVICE_PLUGIN(makePadDriver)
