// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/stylus.h"

#include <vector>

namespace burin::test {

/// A stylus with two axes that spring back, a trigger, a slider and three buttons.
class AxesStylus final : public Stylus {
public:
    StylusDescription description() const override {
        StylusDescription description;
        description.name = "axes";
        description.buttons = 3;
        description.workspaceRadius = {50.0, "a test"};
        return description;
    }
    Result<void> open() override {
        isOpen = true;
        return {};
    }
    void close() noexcept override { isOpen = false; }
    StylusState read(double time) noexcept override {
        StylusState state;
        state.time = time;
        state.valid = true;
        return state;
    }
    void write(const Wrench&) noexcept override {}
    std::vector<DeviceAxis> axes() const override {
        return {{"right"}, {"down"}, {"trigger", true, true}, {"slider", false}};
    }
    AxisMap axisMap() const override {
        AxisMap usual;
        usual.axes[0] = {AxisMotion::x, false, 1.0, 0.05};
        usual.axes[1] = {AxisMotion::z, true, 1.0, 0.05};
        usual.axes[2] = {AxisMotion::z, true, 1.0, 0.05, -1.0, -1.0, 1.0};
        return usual;
    }
    void assign(const AxisMap& assigned) noexcept override { map = assigned; }
    AxisReading axisReading() const noexcept override { return reading; }

    AxisMap map = axisMap();
    AxisReading reading;
    bool isOpen = false;
};

} // namespace burin::test
