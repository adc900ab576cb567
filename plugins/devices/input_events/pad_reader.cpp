// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/pad_reader.h"

#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin::input_events {
namespace {

constexpr std::size_t mostButtons = 32;

struct AxisName {
    unsigned int code;
    TextId name;
};
/// Every axis that a pad or joystick may have.
constexpr std::array padAxisNames{
    AxisName{ABS_X, BURIN_TEXT("Device", "X")},
    AxisName{ABS_Y, BURIN_TEXT("Device", "Y")},
    AxisName{ABS_Z, BURIN_TEXT("Device", "Z")},
    AxisName{ABS_RX, BURIN_TEXT("Device", "RX")},
    AxisName{ABS_RY, BURIN_TEXT("Device", "RY")},
    AxisName{ABS_RZ, BURIN_TEXT("Device", "RZ")},
    AxisName{ABS_HAT0X, BURIN_TEXT("Device", "hat X")},
    AxisName{ABS_HAT0Y, BURIN_TEXT("Device", "hat Y")},
    AxisName{ABS_THROTTLE, BURIN_TEXT("Device", "throttle")},
    AxisName{ABS_RUDDER, BURIN_TEXT("Device", "rudder")},
    AxisName{ABS_WHEEL, BURIN_TEXT("Device", "wheel")},
    AxisName{ABS_GAS, BURIN_TEXT("Device", "gas")},
};
static_assert(padAxisNames.size() <= AxisMap::mostAxes);

bool has(const libevdev& device, unsigned int axis) {
    return libevdev_has_event_code(&device, EV_ABS, axis) != 0;
}

} // namespace

PadReader::PadReader(const libevdev& device) {
    addAxes(device);
    for (unsigned int code = BTN_MISC; code < KEY_MAX && buttons_.size() < mostButtons; ++code)
        if (libevdev_has_event_code(&device, EV_KEY, code) != 0) buttons_.push_back(code);
}

void PadReader::addAxes(const libevdev& device) {
    constexpr bool reversed = true, oneSided = true;
    addAxis(device, ABS_X, AxisMotion::x);
    addAxis(device, ABS_Y, AxisMotion::y, reversed); // towards the user
    if (has(device, ABS_RX) && has(device, ABS_RY)) {
        addAxis(device, ABS_RY, AxisMotion::z, reversed);
        addAxis(device, ABS_RX, AxisMotion::c, reversed);
        addAxis(device, ABS_RZ, AxisMotion::z, reversed, oneSided);
        addAxis(device, ABS_Z, AxisMotion::z, false, oneSided);
    } else if (has(device, ABS_Z) && has(device, ABS_RZ)) {
        addAxis(device, ABS_RZ, AxisMotion::z, reversed);
        addAxis(device, ABS_Z, AxisMotion::c, reversed);
    } else {
        addAxis(device, ABS_HAT0Y, AxisMotion::z, reversed);
        addAxis(device, ABS_RZ, AxisMotion::c, reversed);
    }
    for (const AxisName& other : padAxisNames)
        if (std::ranges::find(axes_, other.code, &Axis::code) == axes_.end()) addAxis(device, other.code);
}

void PadReader::addAxis(const libevdev& device, unsigned int code, AxisMotion motion, bool reversed, bool oneSided) {
    const input_absinfo* const info = libevdev_get_abs_info(&device, code);
    if (info == nullptr || info->maximum <= info->minimum) return;
    const double low = info->minimum, high = info->maximum;
    AxisUse& use = map_.axes[axes_.size()];
    use.motion = motion;
    use.reversed = reversed;
    use.deadZone = std::clamp(2.0 * info->flat / (high - low), deadZone, 0.5);
    if (oneSided) use.rest = use.low;
    controls_.axes[axes_.size()] = static_cast<std::int16_t>(std::lround(fullScale * use.rest));
    controls_.silent |= 1U << axes_.size();
    const bool springs = code != ABS_THROTTLE && code != ABS_WHEEL;
    named_.push_back({std::ranges::find(padAxisNames, code, &AxisName::code)->name.text, springs, oneSided});
    axes_.push_back({code, low, high});
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
    const auto index = static_cast<std::size_t>(axis - axes_.begin());
    controls_.silent &= ~(1U << index);
    controls_.axes[index] = static_cast<std::int16_t>(std::lround(fullScale * (2.0 * share - 1.0)));
    return Kind::motion;
}

} // namespace burin::input_events
