// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/pen_mapping.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace burin::input_events {
namespace {

/// The rotation from upright to a tilt to the right and away from the user.
glm::dquat leaning(double x, double y) noexcept {
    const double lean = std::hypot(x, y);
    if (!(lean > 1e-6)) return {1.0, 0.0, 0.0, 0.0};
    // About the horizontal axis perpendicular to the direction of the tilt.
    return glm::angleAxis(std::min(lean, PenMapping::mostLean), glm::dvec3(-y, x, 0.0) / lean);
}

} // namespace

std::vector<DeviceAxis> penAxes() {
    return {{BURIN_TEXT("Device", "position to the right").text, false},
            {BURIN_TEXT("Device", "position away from the user").text, false},
            {BURIN_TEXT("Device", "pressure").text, false, true},
            {BURIN_TEXT("Device", "tilt to the right").text, false},
            {BURIN_TEXT("Device", "tilt away from the user").text, false}};
}

AxisMap penMap() {
    AxisMap map;
    map.axes[0].motion = AxisMotion::x;
    map.axes[1].motion = AxisMotion::y;
    map.axes[2] = {AxisMotion::z, true, 1.0, 0.0, -1.0, -1.0, 1.0};
    map.axes[3].motion = AxisMotion::b; // about y: from z towards x
    map.axes[4] = {AxisMotion::a, true};
    return map;
}

AxisReading readingOf(const Pen& pen, const TabletReader& reader) noexcept {
    AxisReading reading;
    reading.values = {2.0 * pen.x / reader.width(), 2.0 * pen.y / reader.height(), 2.0 * pen.pressure - 1.0,
                      pen.leanX / PenMapping::mostLean, pen.leanY / PenMapping::mostLean};
    reading.buttons = pen.buttons;
    return reading;
}

Pen mappedPen(const Pen& pen, const AxisMap& map, const TabletReader& reader) noexcept {
    const MotionShares motions = motionsOf(map, readingOf(pen, reader).values);
    const auto share = [&motions](AxisMotion motion) { return motions[static_cast<std::size_t>(motion) - 1]; };
    Pen mapped = pen;
    mapped.x = 0.5 * reader.width() * share(AxisMotion::x);
    mapped.y = 0.5 * reader.height() * share(AxisMotion::y);
    mapped.pressure = -share(AxisMotion::z);
    mapped.leanX = PenMapping::mostLean * share(AxisMotion::b);
    mapped.leanY = -PenMapping::mostLean * share(AxisMotion::a);
    mapped.buttons = sessionButtons(map, pen.buttons);
    return mapped;
}

const Pose& PenMapping::advance(const Pen& pen, double seconds) noexcept {
    const double step = std::clamp(seconds, 0.0, longestStep), share = 1.0 - std::exp(-step / lag);
    const bool touches = (pen.buttons & 1U) != 0;
    const glm::dvec3 target(pen.x, pen.y, touches ? -depth * pen.pressure : lift);
    pose_.position += clampLength(share * (target - pose_.position), followSpeed * step);
    pose_.rotation = glm::normalize(glm::slerp(pose_.rotation, leaning(pen.leanX, pen.leanY), share));
    return pose_;
}

} // namespace burin::input_events
