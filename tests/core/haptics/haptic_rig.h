// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/haptics/haptic_step.h"
#include "tests/core/device/desktop_stylus.h"
#include "tests/core/haptics/analytic_fields.h"

#include <cstdlib>
#include <functional>

namespace burin::test {

inline constexpr double voxel = 0.5;
inline constexpr double period = 0.001;
inline constexpr double floorHeight = -10.0; ///< mm, top of the protected part

inline Tool ballTool(double fluteLength = 12.0, double shankDiameter = 6.0) {
    Tool tool;
    tool.id = "ball-6";
    tool.cutter.type = CutterType::ball;
    tool.cutter.diameter = 6.0;
    tool.cutter.cornerRadius = 3.0;
    tool.cutter.fluteLength = fluteLength;
    tool.cutter.shankDiameter = shankDiameter;
    tool.cutter.stickOut = 40.0;
    return tool;
}

inline Property material(const char* id, Machinability machinability) {
    Property property;
    property.id = id;
    property.machinability = machinability;
    property.values[std::string(specificCuttingEnergy)] = {0.7, "J/mm^3", "test", true};
    property.values[std::string(radialForceRatio)] = {0.3, "1", "test", true};
    return property;
}

/// A block, 40 × 40 mm, of stock from `floorHeight` up to z = 0; the part below it; air up to z = 10.
inline RunVolume stockOnPart(std::size_t reservedBytes = 0, bool withStock = true) {
    PropertyList properties;
    const PropertyIndex stock = *properties.add(material("stock", Machinability::machinable));
    const PropertyIndex part = *properties.add(material("part", Machinability::isProtected));
    const Grid grid = *Grid::make({-20.0, -20.0, -20.0}, voxel, {80, 80, 60});
    RunVolume volume = *RunVolume::make(grid, properties, reservedBytes);
    const RunPosition floor = grid.toRunPosition(floorHeight), top = grid.toRunPosition(0.0);
    for (std::int32_t v = 0; v < grid.lineCountV(); ++v)
        for (std::int32_t u = 0; u < grid.lineCountU(); ++u) {
            bool filled = volume.fillSpan({u, v}, 0, floor, part);
            if (withStock) filled = filled && volume.fillSpan({u, v}, floor, top, stock);
            if (!filled) std::abort(); // the test's own set-up
        }
    return volume;
}

/// The part of `stockOnPart`, for a ball of radius 3.
struct FloorSolid {
    double distance(const glm::dvec3& p) const noexcept { return p.z - floorHeight; }
};
using FloorField = BallField<FloorSolid>;

/// A step on a stock with its part, fed with positions of the hand.
struct Rig {
    explicit Rig(HapticSettings wanted = settings(), const Tool& tool = ballTool(), RunVolume workpiece = stockOnPart())
        : volume(std::move(workpiece)), step(volume, field, tool, wanted) {}

    static HapticSettings settings() {
        HapticSettings settings;
        settings.stylus = desktopStylus();
        settings.rampSeconds = 0.0;
        return settings;
    }
    Sample feed(const glm::dvec3& device) {
        StylusState state;
        state.time = 0.0;
        state.pose.position = device;
        state.buttons = buttons;
        state.valid = true;
        return step.advance(state, period);
    }
    /// Moves the hand in a straight line at `speed` (mm/s). @return the last tick's record
    Sample moveTo(const glm::dvec3& target, double speed) {
        const int ticks = std::max(1, static_cast<int>(std::ceil(glm::length(target - hand) / (speed * period))));
        const glm::dvec3 from = hand;
        Sample last;
        for (int i = 1; i <= ticks; ++i) {
            last = feed(glm::mix(from, target, static_cast<double>(i) / ticks));
            onTick(last);
        }
        hand = target;
        return last;
    }
    Sample rest(int ticks) {
        Sample last;
        for (int i = 0; i < ticks; ++i) {
            last = feed(hand);
            onTick(last);
        }
        return last;
    }
    void begin(const glm::dvec3& at) {
        hand = at;
        feed(at);
    }

    std::function<void(const Sample&)> onTick = [](const Sample&) {};
    FloorField field{FloorSolid{}, 3.0};
    RunVolume volume;
    HapticStep step;
    glm::dvec3 hand{0.0};
    std::uint32_t buttons = 0;
};

} // namespace burin::test
