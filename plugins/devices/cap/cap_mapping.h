// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"

#include <array>
#include <cstdint>

namespace burin::cap {

enum class ControlMode : std::uint8_t {
    rate,    ///< the deflection of the cap sets the velocity of the tool; released, the tool stops
    position ///< the deflection of the cap sets the position of the tool; released, it returns to its start
};

/// Computes a pose from the deflection of the cap. Device frame: x right, y away from the user, z up; the cap's own
/// frame is rotated by 180° about x. One thread; no allocation, no exception.
class CapMapping {
public:
    static constexpr double fullScale = 350.0; ///< counts; larger values are limited to it
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
    /// @param seconds since the previous call, >= 0
    const Pose& advance(const std::array<std::int16_t, 6>& axes, double seconds) noexcept;

    /// The deflectionResponse of an axis, -1 … 1, for its counts.
    static double response(std::int16_t counts) noexcept;

private:
    void follow(const Pose& target, double step) noexcept;

    ControlMode mode_;
    Pose pose_;
};

} // namespace burin::cap
