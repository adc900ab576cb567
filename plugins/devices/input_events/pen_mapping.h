// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/axis_map.h"
#include "core/geometry/pose.h"
#include "plugins/devices/input_events/tablet_reader.h"

#include <vector>

namespace burin::input_events {

/// The axes of a pen on a tablet and how they move the tool unless the user assigns them differently: the position
/// along the two sides of the tablet, the pressure, and both tilts up to PenMapping::mostLean.
std::vector<DeviceAxis> penAxes();
AxisMap penMap();

/// The readings of a pen's axes. @param reader of its tablet
AxisReading readingOf(const Pen& pen, const TabletReader& reader) noexcept;

/// The pen as the user's map has it: its motions along x and y are shares of half the tablet's sides, down is pressure,
/// rotations are tilts. A rotation about the pen itself does not exist.
Pen mappedPen(const Pen& pen, const AxisMap& map, const TabletReader& reader) noexcept;

/// Computes a pose from the state of a pen: the position on the tablet, a depth according to the pressure, and the tilt
/// of the pen. A pen in the air holds the tool above the plane. It can be put down anywhere: the tool moves there with
/// limited speed. Device frame: x right, y away from the user, z up. One thread; no allocation, no exception.
class PenMapping {
public:
    static constexpr double depth = 10.0;        ///< mm at full pressure
    static constexpr double lift = 5.0;          ///< mm, height of a pen that does not touch the tablet
    static constexpr double followSpeed = 400.0; ///< mm/s
    static constexpr double lag = 0.02; ///< s: smooths the reports, which arrive 100 to 300 times a second, in steps
    static constexpr double mostLean = 1.0;     ///< rad, largest tilt
    static constexpr double longestStep = 0.05; ///< s, longest time by which one call moves the pose

    void reset() noexcept { *this = PenMapping(); }
    /// @param seconds since the previous call, >= 0
    const Pose& advance(const Pen& pen, double seconds) noexcept;

private:
    Pose pose_{{0.0, 0.0, lift}, {1.0, 0.0, 0.0, 0.0}};
};

} // namespace burin::input_events
