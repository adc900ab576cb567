// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/pad_reader.h"

#include "plugins/devices/cap/cap_mapping.h"

#include <algorithm>
#include <cmath>

namespace burin::input_events {
namespace {

// Indices in Controls::axes: x right, y towards the user, z down, and the rotation about z.
constexpr std::size_t right = 0, towards = 1, down = 2, turn = 5;
constexpr std::size_t mostButtons = 32;

bool has(const libevdev& device, unsigned int axis) {
    return libevdev_has_event_code(&device, EV_ABS, axis) != 0;
}

} // namespace

PadReader::PadReader(const libevdev& device) {
    addAxis(device, ABS_X, right, 1.0);
    addAxis(device, ABS_Y, towards, 1.0);
    if (has(device, ABS_RX) && has(device, ABS_RY)) {
        addAxis(device, ABS_RY, down, 1.0);
        addAxis(device, ABS_RX, turn, 1.0);
        addAxis(device, ABS_RZ, down, 1.0, true);
        addAxis(device, ABS_Z, down, -1.0, true);
    } else if (has(device, ABS_Z) && has(device, ABS_RZ)) {
        addAxis(device, ABS_RZ, down, 1.0);
        addAxis(device, ABS_Z, turn, 1.0);
    } else {
        addAxis(device, ABS_HAT0Y, down, 1.0);
        addAxis(device, ABS_RZ, turn, 1.0);
    }
    for (unsigned int code = BTN_MISC; code < KEY_MAX && buttons_.size() < mostButtons; ++code)
        if (libevdev_has_event_code(&device, EV_KEY, code) != 0) buttons_.push_back(code);
}

void PadReader::addAxis(const libevdev& device, unsigned int code, std::size_t target, double sign, bool oneSided) {
    const input_absinfo* const info = libevdev_get_abs_info(&device, code);
    if (info == nullptr || info->maximum <= info->minimum) return;
    Axis axis;
    axis.code = code;
    axis.low = info->minimum;
    axis.high = info->maximum;
    axis.dead = std::clamp(2.0 * info->flat / (axis.high - axis.low), deadZone, 0.5);
    axis.oneSided = oneSided;
    axis.target = target;
    axis.sign = sign;
    axes_.push_back(axis);
}

PadReader::Kind PadReader::take(const input_event& event) noexcept {
    if (event.type == EV_KEY) {
        const auto button = std::ranges::find(buttons_, event.code);
        if (button == buttons_.end()) return Kind::none;
        const std::uint32_t bit = 1U << static_cast<unsigned int>(button - buttons_.begin());
        controls_.buttons = event.value != 0 ? controls_.buttons | bit : controls_.buttons & ~bit;
        return Kind::button;
    }
    const auto axis = std::ranges::find(axes_, event.code, &Axis::code);
    if (event.type != EV_ABS || axis == axes_.end()) return Kind::none;
    const double share = std::clamp((event.value - axis->low) / (axis->high - axis->low), 0.0, 1.0);
    const double pushed = axis->oneSided ? share : 2.0 * share - 1.0;
    const double beyond = std::max(0.0, std::abs(pushed) - axis->dead) / (1.0 - axis->dead);
    axis->value = axis->sign * std::copysign(beyond, pushed);
    double sum = 0.0;
    for (const Axis& other : axes_)
        if (other.target == axis->target) sum += other.value;
    controls_.axes[axis->target] =
        static_cast<std::int16_t>(std::lround(cap::CapMapping::fullScale * std::clamp(sum, -1.0, 1.0)));
    return Kind::motion;
}

} // namespace burin::input_events
