// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/tablet_reader.h"

#include "core/base/units.h"

#include <algorithm>

namespace burin::input_events {
namespace {

enum PenButton : std::uint32_t { touch = 1u << 0, first = 1u << 1, second = 1u << 2, third = 1u << 3 };

std::uint32_t buttonOf(unsigned int code) noexcept {
    switch (code) {
    case BTN_TOUCH:
        return touch;
    case BTN_STYLUS:
        return first;
    case BTN_STYLUS2:
        return second;
    case BTN_STYLUS3:
        return third;
    default:
        return 0;
    }
}

bool isTool(unsigned int code) noexcept {
    return code == BTN_TOOL_PEN || code == BTN_TOOL_RUBBER || code == BTN_TOOL_BRUSH || code == BTN_TOOL_PENCIL ||
           code == BTN_TOOL_AIRBRUSH;
}

} // namespace

double TabletReader::Axis::fromMiddle(int value) const noexcept {
    return (std::clamp<double>(value, low, high) - 0.5 * (low + high)) / perUnit;
}

double TabletReader::Axis::share(int value) const noexcept {
    return std::clamp((value - low) / span(), 0.0, 1.0);
}

TabletReader::Axis TabletReader::axisOf(const libevdev& device, unsigned int code) noexcept {
    Axis axis;
    const input_absinfo* const info = libevdev_get_abs_info(&device, code);
    if (info == nullptr || info->maximum <= info->minimum) return axis;
    axis.known = true;
    axis.low = info->minimum;
    axis.high = info->maximum;
    axis.perUnit = info->resolution;
    return axis;
}

TabletReader::TabletReader(const libevdev& device) noexcept
    : x_(axisOf(device, ABS_X))
    , y_(axisOf(device, ABS_Y))
    , pressure_(axisOf(device, ABS_PRESSURE))
    , tiltX_(axisOf(device, ABS_TILT_X))
    , tiltY_(axisOf(device, ABS_TILT_Y)) {
    statesSize_ = x_.perUnit > 0.0 && y_.perUnit > 0.0;
    if (!statesSize_) x_.perUnit = y_.perUnit = x_.span() / assumedWidth;
    // Without a stated resolution, tilts are in degrees, as is usual for drivers of tablets.
    for (Axis* tilt : {&tiltX_, &tiltY_})
        if (!(tilt->perUnit > 0.0)) tilt->perUnit = 180.0 / pi;
}

void TabletReader::move(const input_event& event) noexcept {
    switch (event.code) {
    case ABS_X:
        pen_.x = x_.fromMiddle(event.value);
        break;
    case ABS_Y:
        pen_.y = -y_.fromMiddle(event.value);
        break;
    case ABS_PRESSURE:
        pen_.pressure = pressure_.known ? pressure_.share(event.value) : 0.0;
        break;
    case ABS_TILT_X:
        if (tiltX_.known) pen_.leanX = tiltX_.fromMiddle(event.value);
        break;
    case ABS_TILT_Y:
        if (tiltY_.known) pen_.leanY = -tiltY_.fromMiddle(event.value);
        break;
    default:
        break;
    }
}

void TabletReader::press(const input_event& event) noexcept {
    if (isTool(event.code)) {
        pen_.near = event.value != 0;
        return;
    }
    const std::uint32_t button = buttonOf(event.code);
    pen_.buttons = event.value != 0 ? pen_.buttons | button : pen_.buttons & ~button;
}

bool TabletReader::take(const input_event& event) noexcept {
    if (event.type == EV_ABS) move(event);
    if (event.type == EV_KEY) press(event);
    if (event.type != EV_SYN || event.code != SYN_REPORT) return false;
    // A pen that went away keeps its position, and touches nothing.
    if (!pen_.near) {
        pen_.pressure = 0.0;
        pen_.buttons = 0;
    }
    told_ = pen_;
    return true;
}

void TabletReader::rest() noexcept {
    pen_.near = false;
    pen_.pressure = 0.0;
    pen_.buttons = 0;
    told_ = pen_;
}

} // namespace burin::input_events
