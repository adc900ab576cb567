// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/coolant.h"
#include "core/base/estimate.h"
#include "core/base/units.h"
#include "core/geometry/box.h"
#include "core/machine/axis.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// How a control executes a rapid that moves several axes.
enum class RapidMode : std::uint8_t {
    synchronised, ///< straight; all axes arrive together, none faster than its own rate
    independent,  ///< each axis at its own rate until it arrives: a bent path ("dog-leg")
    tip,          ///< straight, the tip at the rapid feed, but no axis faster than its own rate
};

/// How a control passes the corner between two blocks.
enum class JunctionRule : std::uint8_t {
    exactStop, ///< the axes stop at every corner
    /// at the speed of an arc that deviates from the corner by the tolerance, at the acceleration (GRBL's $11)
    deviation,
    blend, ///< rounds the corner by a parabola that deviates from it by at most the tolerance (LinuxCNC's G64 P)
};

/// The arcs that a control accepts. Other arcs have to be split or posted as lines.
struct ArcRules {
    double largestSweep = 2.0 * pi; ///< rad, of one block; 2 pi: whole circles are accepted; 0: no arcs
    double smallestRadius = 0.0;    ///< mm
    double largestRadius = 1e4;     ///< mm
    double radiusMismatch = 0.002;  ///< mm, largest difference of the radii at start and end
};

/// A rotary axis that tilts the tool relative to the workpiece, whether it carries the one or the other.
struct RotaryAxis {
    Axis axis = Axis::a; ///< A about X, B about Y, C about Z
    /// As ISO 841 has it, the tool turns right-handed about the axis, seen from the workpiece. True: the other way.
    bool reversed = false;
    double low = -std::numeric_limits<double>::infinity(); ///< degrees
    double high = std::numeric_limits<double>::infinity();
    double rate = 0.0;         ///< degrees/min; 0: not stated
    double acceleration = 0.0; ///< degrees/s²; 0: without limit

    friend bool operator==(const RotaryAxis&, const RotaryAxis&) = default;
};

/// Time that a spindle is given to reach its speed, s.
inline constexpr double spindleStartTime = 3.0;

/// Torque of a spindle at one speed in continuous operation.
struct SpindlePoint {
    double speed = 0.0;  ///< 1/min
    double torque = 0.0; ///< N m
};

/// A machine and its control, plain data. resources/machines/<id>.json; core/machine/README.md explains each key.
struct MachineProfile {
    std::string id;
    std::string name;
    std::string source;                         ///< source of the values, unless `sources` names another
    std::map<std::string, std::string> sources; ///< by key of the file: the source of that value
    std::string dialect;                        ///< id of the dialect that its control reads; empty: not stated
    glm::dvec3 travel{0.0};                     ///< mm along X, Y, Z
    double maximumFeed = 0.0;                   ///< mm/min, cutting
    double rapidFeed = 0.0;                     ///< mm/min
    glm::dvec3 axisRates{0.0};                  ///< mm/min, maximum of each axis; 0: the rapid feed (see axisRate)
    double minimumSpindleSpeed = 0.0;           ///< 1/min
    double maximumSpindleSpeed = 0.0;           ///< 1/min
    double spindlePower = 0.0;                  ///< W; 0: not stated
    std::vector<SpindlePoint> spindleTorque{};  ///< by rising speed; empty: not stated (see torqueAt)
    double acceleration = 0.0;                  ///< mm/s², of axes without a value of their own; 0: without limit
    glm::dvec3 axisAccelerations{0.0};          ///< mm/s², of each axis; 0: `acceleration` (see axisAcceleration)
    glm::dvec3 axisJerks{0.0};                  ///< mm/s³, of each axis; 0: without limit
    double blocksPerSecond = 0.0;               ///< maximum that the control executes; 0: not stated
    double toolChangeSeconds = 0.0;             ///< s, from chip to chip
    double toolChangeHeight = 0.0; ///< mm above the work offset's zero; this height can always be reached safely
    RapidMode rapids = RapidMode::synchronised;
    JunctionRule junctions = JunctionRule::blend;
    double junctionTolerance = 0.01; ///< mm; for `blend` if the program states none
    ArcRules arcs;
    /// Coolants that it can switch on. Empty: the profile does not say, so that the codes that the control knows
    /// decide.
    std::optional<std::vector<Coolant>> coolants{};
    int coordinateDecimals = 3;  ///< digits after the decimal point in mm
    int maximumLineLength = 255; ///< characters
    /// mm, machine frame: where the spindle parks for a tool change and at the end, first Z, then X and Y; empty: not
    /// stated, so that the spindle stays where the dialect leaves it.
    std::optional<glm::dvec3> home{};
    /// One or two rotary axes, in order from the workpiece: the first one turns the second. Empty: the tool is upright.
    /// X, Y and Z are then those of the tip on the workpiece: the control compensates the rotation (RTCP).
    std::vector<RotaryAxis> rotaryAxes{};

    /// Whether the value of a key is an estimate, according to its source.
    bool isEstimate(const std::string& key) const {
        const auto own = sources.find(key);
        return burin::isEstimate(own != sources.end() ? own->second : source);
    }
    /// Whether it can tilt the tool.
    bool tilts() const noexcept { return !rotaryAxes.empty(); }
    AxisSet axes() const noexcept {
        AxisSet axes = linearAxes;
        for (const RotaryAxis& rotary : rotaryAxes) axes.set(rotary.axis);
        return axes;
    }
    const RotaryAxis* rotaryAxis(Axis axis) const noexcept {
        const auto found = std::ranges::find(rotaryAxes, axis, &RotaryAxis::axis);
        return found != rotaryAxes.end() ? &*found : nullptr;
    }
    bool has(Coolant coolant) const noexcept {
        return coolant == Coolant::off || !coolants || std::ranges::find(*coolants, coolant) != coolants->end();
    }
    /// The maximum rate of an axis (0, 1, 2), mm/min.
    double axisRate(int axis) const noexcept { return axisRates[axis] > 0.0 ? axisRates[axis] : rapidFeed; }
    /// Torque of the spindle at a speed, N m; 0: not stated. The power is interpolated linearly between two points,
    /// which is exact for constant torque as well as for constant power. Below the first point the torque is constant,
    /// above the last one the power. @param speed 1/min, > 0
    double torqueAt(double speed) const noexcept {
        if (spindleTorque.empty()) return 0.0;
        if (speed <= spindleTorque.front().speed) return spindleTorque.front().torque;
        const auto above = std::ranges::lower_bound(spindleTorque, speed, {}, &SpindlePoint::speed);
        const SpindlePoint& low = *(above - 1);
        if (above == spindleTorque.end()) return low.torque * low.speed / speed;
        const double share = (speed - low.speed) / (above->speed - low.speed);
        return std::lerp(low.torque * low.speed, above->torque * above->speed, share) / speed;
    }
    /// Power of the spindle at a speed, W: the smaller of its stated power and the power from its torque; 0: not
    /// stated.
    /// @param speed 1/min, > 0
    double powerAt(double speed) const noexcept {
        const double ofTorque = torqueAt(speed) * 2.0 * pi * speed / secondsPerMinute;
        return spindlePower > 0.0 && ofTorque > 0.0 ? std::min(spindlePower, ofTorque)
                                                    : std::max(spindlePower, ofTorque);
    }
    /// Acceleration of an axis, mm/s²; 0: without limit.
    double axisAcceleration(int axis) const noexcept {
        return axisAccelerations[axis] > 0.0 ? axisAccelerations[axis] : acceleration;
    }
};

} // namespace burin
