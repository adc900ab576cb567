// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"

#include <array>
#include <cstdint>

namespace burin::cap {

enum class ControlMode : std::uint8_t {
    rate,    ///< the cap says how fast the tool moves; let go, it stands
    position ///< the cap says where the tool is; let go, it is back at its start
};

/// Makes a pose of what the cap does. Device frame: x right, y away from the user, z up; the cap's own frame is turned
/// by half a turn about x. One thread; no allocation, no exception.
class CapMapping {
public:
    static constexpr double fullScale = 350.0;      ///< counts; more is cut off
    static constexpr double topSpeed = 100.0;       ///< mm/s, rate
    static constexpr double topTurn = 1.5;          ///< rad/s, rate
    static constexpr double reach = 40.0;           ///< mm, position
    static constexpr double turnReach = 0.5;        ///< rad, position
    static constexpr double lag = 0.04;             ///< s, position: reports come 60 to 125 times a second, in steps
    static constexpr double followSpeed = 400.0;    ///< mm/s, position
    static constexpr double workspaceRadius = 75.0; ///< mm; the pose stays within
    static constexpr double longestStep = 0.05;     ///< s that one call may move the pose

    explicit CapMapping(ControlMode mode) noexcept : mode_(mode) {}
    void reset() noexcept { pose_ = {}; }
    /// @param seconds since the call before, >= 0
    const Pose& advance(const std::array<std::int16_t, 6>& axes, double seconds) noexcept;

    /// -1 … 1 of an axis: deflectionResponse of what it counts.
    static double response(std::int16_t counts) noexcept;

private:
    void follow(const Pose& target, double step) noexcept;

    ControlMode mode_;
    Pose pose_;
};

} // namespace burin::cap
