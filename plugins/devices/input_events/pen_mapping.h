// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"
#include "plugins/devices/input_events/tablet_reader.h"

namespace burin::input_events {

/// Makes a pose of what a pen does: where it is on the tablet, as deep as it is pressed, leaning as it leans. A pen in
/// the air holds the tool above. It can be put down anywhere: the tool goes there no faster than it may. Device frame:
/// x right, y away from the user, z up. One thread; no allocation, no exception.
class PenMapping {
public:
    static constexpr double depth = 10.0;        ///< mm at full pressure
    static constexpr double lift = 5.0;          ///< mm, of a pen that does not touch
    static constexpr double followSpeed = 400.0; ///< mm/s
    static constexpr double lag = 0.02;          ///< s: reports come 100 to 300 times a second, in steps
    static constexpr double mostLean = 1.0;      ///< rad
    static constexpr double longestStep = 0.05;  ///< s that one call may move the pose

    void reset() noexcept { *this = PenMapping(); }
    /// @param seconds since the call before, >= 0
    const Pose& advance(const Pen& pen, double seconds) noexcept;

private:
    Pose pose_{{0.0, 0.0, lift}, {1.0, 0.0, 0.0, 0.0}};
};

} // namespace burin::input_events
