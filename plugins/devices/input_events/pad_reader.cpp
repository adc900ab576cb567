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

/// An axis that a pad or joystick may have.
struct PadAxis {
    unsigned int code;
    TextId name;
    bool springs = true, oneSided = false; ///< see DeviceAxis
};
/// Of a device with more than AxisMap::mostAxes of them the last ones are left out.
constexpr std::array padAxes{
    PadAxis{ABS_X, BURIN_TEXT("Device", "X")},
    PadAxis{ABS_Y, BURIN_TEXT("Device", "Y")},
    PadAxis{ABS_Z, BURIN_TEXT("Device", "Z")},
    PadAxis{ABS_RX, BURIN_TEXT("Device", "RX")},
    PadAxis{ABS_RY, BURIN_TEXT("Device", "RY")},
    PadAxis{ABS_RZ, BURIN_TEXT("Device", "RZ")},
    PadAxis{ABS_HAT0X, BURIN_TEXT("Device", "hat X")},
    PadAxis{ABS_HAT0Y, BURIN_TEXT("Device", "hat Y")},
    PadAxis{ABS_GAS, BURIN_TEXT("Device", "gas"), true, true}, // a pedal, or the right trigger of some pads
    PadAxis{ABS_BRAKE, BURIN_TEXT("Device", "brake"), true, true},
    PadAxis{ABS_THROTTLE, BURIN_TEXT("Device", "throttle"), false},
    PadAxis{ABS_RUDDER, BURIN_TEXT("Device", "rudder")},
    PadAxis{ABS_WHEEL, BURIN_TEXT("Device", "wheel"), false},
};

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
    for (const PadAxis& other : padAxes)
        if (std::ranges::find(axes_, other.code, &Axis::code) == axes_.end())
            addAxis(device, other.code, AxisMotion::none, false, other.oneSided);
}

void PadReader::addAxis(const libevdev& device, unsigned int code, AxisMotion motion, bool reversed, bool oneSided) {
    const input_absinfo* const info = libevdev_get_abs_info(&device, code);
    if (info == nullptr || info->maximum <= info->minimum || axes_.size() == AxisMap::mostAxes) return;
    const double low = info->minimum, high = info->maximum;
    AxisUse& use = map_.axes[axes_.size()];
    use.motion = motion;
    use.reversed = reversed;
    use.deadZone = std::clamp(2.0 * info->flat / (high - low), deadZone, 0.5);
    if (oneSided) use.rest = use.low;
    controls_.axes[axes_.size()] = static_cast<std::int16_t>(std::lround(fullScale * use.rest));
    controls_.silent |= 1U << axes_.size();
    const PadAxis& known = *std::ranges::find(padAxes, code, &PadAxis::code);
    named_.push_back({known.name.text, known.springs, oneSided});
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
