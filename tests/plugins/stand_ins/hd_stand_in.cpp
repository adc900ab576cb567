// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/plugins/stand_ins/hd_stand_in.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <thread>

using burin::testing::HdDevice;
using burin::testing::HdStandIn;

namespace {

HdStandIn& hdStandIn() {
    return *burin::testing::burinHdStandIn();
}

constexpr unsigned int none = 0xffffffffU;
constexpr unsigned int badHandle = 0x0104, communication = 0x0302, noFrame = 0x0401;

std::thread schedulerThread;
std::atomic<bool> stopping{false};

void circle(HdDevice& device) {
    constexpr double radius = 10.0, turn = 2.0 * 3.14159265358979323846; // mm, rad/s
    const double time = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    device.transform[12] = radius * std::cos(turn * time);
    device.transform[14] = radius * std::sin(turn * time);
    device.buttons = 1;
}

void complainOutside(HdStandIn& hd, const char* call) {
    if (hd.framed_ == none) hd.complain(std::string(call) + " outside of a frame");
}

} // namespace

namespace burin::testing {

extern "C" [[gnu::visibility("default")]] HdStandIn* burinHdStandIn() {
    static HdStandIn instance;
    static const bool plugged = [] {
        if (std::getenv("BURIN_STAND_IN_TOUCH") == nullptr) return false;
        instance.devices["Default Device"] = HdDevice();
        instance.byHand = false;
        return instance.circles = true;
    }();
    (void)plugged;
    return &instance;
}

void HdStandIn::reset() {
    stop();
    const std::lock_guard lock(mutex);
    devices.clear();
    complaints.clear();
    errors_.clear();
    handles_.clear();
    scheduled_.clear();
    current_ = framed_ = none;
    rate = 0;
    initialisations = 0;
    byHand = true;
}

void HdStandIn::raise(unsigned int code, unsigned int device) {
    const std::lock_guard lock(mutex);
    errors_.emplace_back(code, device != 0 ? device : current_);
}

HdDevice* HdStandIn::find(unsigned int handle) {
    const auto name = handles_.find(handle);
    if (name == handles_.end()) return nullptr;
    return &devices[name->second];
}

unsigned int HdStandIn::connect(const char* name) {
    const std::lock_guard lock(mutex);
    ++initialisations;
    if (running_) complain("hdInitDevice while the scheduler runs");
    const auto found = devices.find(name);
    if (found == devices.end() || !found->second.plugged) {
        errors_.emplace_back(communication, none);
        return none;
    }
    if (found->second.initialised) {
        errors_.emplace_back(0x0301U, none);
        return none;
    }
    found->second.initialised = true;
    handles_[static_cast<unsigned int>(initialisations)] = name;
    return current_ = static_cast<unsigned int>(initialisations);
}

void HdStandIn::step() {
    std::vector<std::pair<unsigned long, Scheduled>> now;
    {
        const std::lock_guard lock(mutex);
        if (!running_) return;
        now.assign(scheduled_.begin(), scheduled_.end());
    }
    for (const auto& [id, scheduled] : now) {
        const bool goesOn = scheduled.callback(scheduled.self) != 0;
        const std::lock_guard lock(mutex);
        if (framed_ != none) complain("a callback left its frame open");
        framed_ = none;
        if (!goesOn) scheduled_.erase(id);
    }
}

void HdStandIn::start() {
    {
        const std::lock_guard lock(mutex);
        if (running_) complain("hdStartScheduler twice");
        if (rate != 1000) complain("started at another rate than 1000 Hz");
        running_ = true;
    }
    if (byHand) return;
    stopping = false;
    schedulerThread = std::thread([this] {
        auto due = std::chrono::steady_clock::now();
        while (!stopping) {
            step();
            due = std::max(due + std::chrono::milliseconds(1), std::chrono::steady_clock::now());
            std::this_thread::sleep_until(due);
        }
    });
}

void HdStandIn::stop() {
    stopping = true;
    if (schedulerThread.joinable()) schedulerThread.join();
    const std::lock_guard lock(mutex);
    running_ = false;
    for (auto& [name, device] : devices) device.force = device.torque = {};
}

} // namespace burin::testing

#define HD_EXPORT extern "C" [[gnu::visibility("default")]]

struct HdErrorRecord {
    unsigned int code;
    int internal;
    unsigned int device;
};

HD_EXPORT unsigned int hdInitDevice(const char* name) {
    return hdStandIn().connect(name);
}

HD_EXPORT void hdDisableDevice(unsigned int handle) {
    HdStandIn& hd = hdStandIn();
    const std::lock_guard lock(hd.mutex);
    HdDevice* device = hd.find(handle);
    if (device == nullptr) return hd.complain("hdDisableDevice of no device");
    if (hd.running_) hd.complain("hdDisableDevice while the scheduler runs");
    if (!device->initialised) hd.complain("hdDisableDevice twice");
    device->initialised = device->forcesOn = false;
    device->force = device->torque = {};
    hd.handles_.erase(handle);
}

HD_EXPORT void hdMakeCurrentDevice(unsigned int handle) {
    HdStandIn& hd = hdStandIn();
    const std::lock_guard lock(hd.mutex);
    if (hd.find(handle) == nullptr) return hd.raise(badHandle);
    hd.current_ = handle;
}

#ifndef HD_WITHOUT_FRAMES
HD_EXPORT void hdBeginFrame(unsigned int handle) {
    HdStandIn& hd = hdStandIn();
    const std::lock_guard lock(hd.mutex);
    HdDevice* device = hd.find(handle);
    if (device == nullptr) return hd.raise(badHandle);
    if (hd.framed_ != none) hd.complain("hdBeginFrame in a frame");
    hd.current_ = hd.framed_ = handle;
    device->setForce = {};
    if (!device->plugged) hd.raise(communication);
}

HD_EXPORT void hdEndFrame(unsigned int handle) {
    HdStandIn& hd = hdStandIn();
    const std::lock_guard lock(hd.mutex);
    if (hd.framed_ != handle) return hd.raise(noFrame);
    hd.framed_ = none;
    HdDevice* device = hd.find(handle);
    device->force = device->forcesOn && device->plugged ? device->setForce : std::array<double, 3>{};
    if (!device->forcesOn || !device->plugged) device->torque = {};
    ++device->frames;
}
#endif

HD_EXPORT HdErrorRecord hdGetError() {
    HdStandIn& hd = hdStandIn();
    const std::lock_guard lock(hd.mutex);
    if (hd.errors_.empty()) return {0, 0, hd.current_};
    const auto [code, device] = hd.errors_.back();
    hd.errors_.pop_back();
    return {code, 0, device};
}

namespace {

void enable(unsigned int capability, bool on) {
    HdStandIn& hd = hdStandIn();
    const std::lock_guard lock(hd.mutex);
    HdDevice* device = hd.find(hd.current_);
    if (device == nullptr) return hd.raise(badHandle);
    if (capability != 0x4000) return;
    device->forcesOn = on;
    if (!on) device->force = device->torque = {};
}

} // namespace

HD_EXPORT void hdEnable(unsigned int capability) {
    enable(capability, true);
}

HD_EXPORT void hdDisable(unsigned int capability) {
    enable(capability, false);
}

HD_EXPORT void hdGetDoublev(unsigned int parameter, double* values) {
    HdStandIn& hd = hdStandIn();
    const std::lock_guard lock(hd.mutex);
    HdDevice* device = hd.find(hd.current_);
    if (device == nullptr) return hd.raise(badHandle);
    switch (parameter) {
    case 0x2052:
        complainOutside(hd, "hdGetDoublev(HD_CURRENT_TRANSFORM)");
        if (hd.circles) circle(*device);
        std::ranges::copy(device->transform, values);
        return;
    case 0x2551: {
        const std::array box{-80.0, -60.0, -35.0, 80.0, 60.0, 35.0};
        std::ranges::copy(box, values);
        return;
    }
    case 0x2602:
        *values = device->stiffness;
        return;
    case 0x2603:
        *values = 3.3;
        return;
    case 0x2604:
        *values = 0.88;
        return;
    case 0x2605:
        std::fill_n(values, 3, device->heat);
        return;
    case 0x2609:
        *values = 0.004;
        return;
    default:
        hd.complain("hdGetDoublev of another parameter");
    }
}

HD_EXPORT void hdGetIntegerv(unsigned int parameter, int* values) {
    HdStandIn& hd = hdStandIn();
    const std::lock_guard lock(hd.mutex);
    HdDevice* device = hd.find(hd.current_);
    if (device == nullptr) return hd.raise(badHandle);
    switch (parameter) {
    case 0x2000:
        complainOutside(hd, "hdGetIntegerv(HD_CURRENT_BUTTONS)");
        *values = device->buttons;
        return;
    case 0x2553:
        *values = 6;
        return;
    case 0x2554:
        *values = device->outputFreedoms;
        return;
    case 0x2555:
        *values = device->calibrationStyles;
        return;
    case 0x2600:
        *values = 1000;
        return;
    default:
        hd.complain("hdGetIntegerv of another parameter");
    }
}

HD_EXPORT void hdSetDoublev(unsigned int parameter, const double* values) {
    HdStandIn& hd = hdStandIn();
    const std::lock_guard lock(hd.mutex);
    HdDevice* device = hd.find(hd.current_);
    if (device == nullptr) return hd.raise(badHandle);
    complainOutside(hd, "hdSetDoublev");
    if (hd.current_ != hd.framed_) hd.complain("hdSetDoublev for another device than the frame's");
    if (parameter == 0x2700)
        std::copy_n(values, 3, device->setForce.begin());
    else if (parameter == 0x2701)
        std::copy_n(values, 3, device->torque.begin());
    else
        hd.complain("hdSetDoublev of another parameter");
}

HD_EXPORT const char* hdGetString(unsigned int /*parameter*/) {
    return "Touch";
}

HD_EXPORT unsigned int hdCheckCalibration() {
    HdStandIn& hd = hdStandIn();
    const std::lock_guard lock(hd.mutex);
    const HdDevice* device = hd.find(hd.current_);
    return device != nullptr ? device->calibration : 0x5002U;
}

HD_EXPORT void hdUpdateCalibration(unsigned int style) {
    HdStandIn& hd = hdStandIn();
    const std::lock_guard lock(hd.mutex);
    HdDevice* device = hd.find(hd.current_);
    if (device == nullptr) return hd.raise(badHandle);
    device->updatedWith = style;
    device->calibration = device->afterUpdate;
}

HD_EXPORT unsigned long hdScheduleAsynchronous(unsigned int (*callback)(void*), void* self, unsigned short priority) {
    HdStandIn& hd = hdStandIn();
    const std::lock_guard lock(hd.mutex);
    if (priority != 0xffff) hd.complain("a callback below the highest priority");
    const unsigned long id = hd.next_++;
    hd.scheduled_[id] = {callback, self};
    return id;
}

HD_EXPORT void hdUnschedule(unsigned long id) {
    HdStandIn& hd = hdStandIn();
    const std::lock_guard lock(hd.mutex);
    if (hd.scheduled_.erase(id) == 0) hd.complain("hdUnschedule of a callback that is not scheduled");
}

HD_EXPORT void hdStartScheduler() {
    hdStandIn().start();
}

HD_EXPORT void hdStopScheduler() {
    hdStandIn().stop();
}

HD_EXPORT void hdSetSchedulerRate(unsigned long rate) {
    hdStandIn().rate = rate;
}
