// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/hid/uinput_device.h"

#include "core/device/device_thread.h"

#include <linux/uinput.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace burin::test {
namespace {

constexpr int pollMilliseconds = 20;

void need(int result, const char* what) {
    if (result >= 0) return;
    std::perror(what);
    std::abort(); // without the kernel's uinput there is no test
}

} // namespace

UinputDevice::UinputDevice(const UinputIdentity& identity) {
    file_ = open("/dev/uinput", O_RDWR | O_CLOEXEC);
    need(file_, "/dev/uinput");
    const auto allow = [this](unsigned long request, unsigned int bit) {
        need(ioctl(file_, request, static_cast<int>(bit)), "uinput");
    };
    for (const unsigned int type : {unsigned{EV_KEY}, unsigned{EV_ABS}, unsigned{EV_FF}}) allow(UI_SET_EVBIT, type);
    for (const unsigned int button : identity.buttons) allow(UI_SET_KEYBIT, button);
    for (const unsigned int effect : identity.effects) allow(UI_SET_FFBIT, effect);
    for (const unsigned int axis : identity.axes) {
        uinput_abs_setup range{};
        range.code = static_cast<std::uint16_t>(axis);
        range.absinfo.minimum = -32768;
        range.absinfo.maximum = 32767;
        need(ioctl(file_, UI_ABS_SETUP, &range), "uinput");
    }
    uinput_setup setup{};
    setup.id = {BUS_USB, identity.vendor, identity.product, 1};
    std::memcpy(setup.name, identity.name.data(), std::min(identity.name.size(), sizeof setup.name - 1));
    setup.ff_effects_max = room;
    need(ioctl(file_, UI_DEV_SETUP, &setup), "uinput");
    need(ioctl(file_, UI_DEV_CREATE), "uinput");
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

/// The thread still answers while the device goes away, as the kernel then removes the effects of those who have it
/// open.
UinputDevice::~UinputDevice() {
    ioctl(file_, UI_DEV_DESTROY);
    thread_.request_stop();
    thread_.join();
    close(file_);
}

void UinputDevice::emit(unsigned int type, unsigned int code, int value) const {
    input_event event{};
    event.type = static_cast<std::uint16_t>(type);
    event.code = static_cast<std::uint16_t>(code);
    event.value = value;
    if (write(file_, &event, sizeof event) != static_cast<ssize_t>(sizeof event)) std::perror("uinput");
}

void UinputDevice::send(unsigned int type, unsigned int code, int value) const {
    emit(type, code, value);
    emit(EV_SYN, SYN_REPORT, 0);
}

void UinputDevice::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        pollfd wanted{file_, POLLIN, 0};
        if (poll(&wanted, 1, pollMilliseconds) <= 0) continue;
        input_event event{};
        if ((wanted.revents & POLLIN) == 0 || read(file_, &event, sizeof event) != static_cast<ssize_t>(sizeof event)) {
            usleep(1000); // it is being destroyed
            continue;
        }
        take(event);
    }
}

void UinputDevice::take(const input_event& event) {
    constexpr double milliseconds = 1e-3;
    const std::lock_guard lock(mutex_);
    if (event.type == EV_UINPUT && event.code == UI_FF_UPLOAD) {
        uinput_ff_upload upload{};
        upload.request_id = static_cast<std::uint32_t>(event.value);
        if (ioctl(file_, UI_BEGIN_FF_UPLOAD, &upload) < 0) return;
        effects_[upload.effect.id].effect = upload.effect;
        upload.retval = 0;
        ioctl(file_, UI_END_FF_UPLOAD, &upload);
    } else if (event.type == EV_UINPUT && event.code == UI_FF_ERASE) {
        uinput_ff_erase erase{};
        erase.request_id = static_cast<std::uint32_t>(event.value);
        if (ioctl(file_, UI_BEGIN_FF_ERASE, &erase) < 0) return;
        effects_.erase(static_cast<int>(erase.effect_id));
        erase.retval = 0;
        ioctl(file_, UI_END_FF_ERASE, &erase);
    } else if (event.type == EV_FF && (event.code == FF_GAIN || event.code == FF_AUTOCENTER)) {
        properties_[event.code].push_back(event.value);
    } else if (event.type == EV_FF) {
        Kept& kept = effects_[event.code];
        kept.endsAt = event.value > 0 ? steadySeconds() + milliseconds * kept.effect.replay.length : 0.0;
    }
}

std::optional<ff_effect> UinputDevice::rendered(std::uint16_t type) {
    const std::lock_guard lock(mutex_);
    for (const auto& [id, kept] : effects_)
        if (kept.effect.type == type && steadySeconds() < kept.endsAt) return kept.effect;
    return std::nullopt;
}

std::vector<int> UinputDevice::values(unsigned int property) {
    const std::lock_guard lock(mutex_);
    return properties_[property];
}

std::size_t UinputDevice::kept() {
    const std::lock_guard lock(mutex_);
    return effects_.size();
}

} // namespace burin::test
