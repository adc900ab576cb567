// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/axis_map.h"
#include "core/geometry/pose.h"

#include <array>
#include <cstdint>
#include <vector>

namespace burin::cap {

enum class ControlMode : std::uint8_t {
    rate,    ///< the deflection of the cap sets the velocity of the tool; released, the tool stops
    position ///< the deflection of the cap sets the position of the tool; released, it returns to its start
};

/// The axes of a cap and how they move the tool unless the user assigns them differently. The cap's own frame (x right,
/// y towards the user, z down) is rotated by 180° about x.
std::vector<DeviceAxis> capAxes();
AxisMap capMap();

/// Counts as shares of the full scale. @param fullScale counts
std::array<double, AxisMap::mostAxes> readingsOf(const std::array<std::int16_t, AxisMap::mostAxes>& counts,
                                                 double fullScale) noexcept;

/// Computes a pose from the deflection of the cap. Device frame: x right, y away from the user, z up. One thread; no
/// allocation, no exception.
class CapMapping {
public:
    static constexpr double fullScale = 350.0; ///< counts of a cap; larger values are limited to it
    static constexpr double deadZone = 0.05;   ///< of each axis of a cap, share
    static constexpr double topSpeed = 100.0;  ///< mm/s, rate
    static constexpr double topTurn = 1.5;     ///< rad/s, rate
    static constexpr double reach = 40.0;      ///< mm, position
    static constexpr double turnReach = 0.5;   ///< rad, position
    /// s, position mode: smooths the reports, which arrive 60 to 125 times a second, in steps
    static constexpr double lag = 0.04;
    static constexpr double followSpeed = 400.0;    ///< mm/s, position
    static constexpr double workspaceRadius = 75.0; ///< mm; the pose stays within
    static constexpr double longestStep = 0.05;     ///< s, longest time by which one call moves the pose

    explicit CapMapping(ControlMode mode) noexcept : mode_(mode) {}
    void reset() noexcept { pose_ = {}; }
    /// @param motions beyond the dead zones of the axes; the response to them is deflectionCurve
    /// @param seconds since the previous call, >= 0
    const Pose& advance(const MotionShares& motions, double seconds) noexcept;

private:
    void follow(const Pose& target, double step) noexcept;

    ControlMode mode_;
    Pose pose_;
};

} // namespace burin::cap
