// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/machine/axis_travel.h"

#include <algorithm>

namespace burin {

AxisTravel::AxisTravel(const MachineProfile& machine, const Box& ends) noexcept {
    for (int component = 0; component < 3; ++component) {
        Ends& axis = ends_[linearAxis(component)];
        axis.length = machine.travel[component];
        if (ends.empty()) continue;
        axis.low = ends.low[component];
        axis.high = ends.high[component];
    }
    for (const RotaryAxis& rotary : machine.rotaryAxes) // wherever the setup is placed
        ends_[rotary.axis] = {rotary.high - rotary.low, rotary.low, rotary.high};
}

void AxisTravel::goTo(AxisSet axes, const AxisValues& values) noexcept {
    for (const Axis axis : axes) goTo(axis, values[axis]);
}

void AxisTravel::goTo(Axis axis, double value) noexcept {
    Way& way = ways_[axis];
    way.low = std::min(way.low, value);
    way.high = std::max(way.high, value);
    way.last = value;
}

std::optional<double> AxisTravel::wayBeyond(Axis axis) const noexcept {
    const Ends& ends = ends_[axis];
    const Way& way = ways_[axis];
    if (way.low > way.high) return std::nullopt; // no position was given
    std::optional<double> beyond;
    if (!(way.high - way.low <= ends.length)) beyond = way.high - way.low;
    if (way.last < ends.low || way.last > ends.high)
        beyond = std::max(beyond.value_or(0.0), std::max(ends.high, way.last) - std::min(ends.low, way.last));
    return beyond;
}

} // namespace burin
