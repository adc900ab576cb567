// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/coolant.h"
#include "core/base/estimate.h"
#include "core/base/units.h"
#include "core/geometry/box.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// How a control makes a rapid that moves several axes.
enum class RapidMode : std::uint8_t {
    synchronised, ///< straight to the end; all axes arrive together, none faster than its own rate
    independent,  ///< each axis at its own rate until it is there: a way with a bend ("dog-leg")
    tip,          ///< straight, the tip at the rapid feed, no axis faster than its own rate
};

/// How fast a control goes through the corner between two blocks.
enum class JunctionRule : std::uint8_t {
    exactStop, ///< it stands still at every corner
    deviation, ///< as if it drove an arc that leaves the corner by the tolerance, at the acceleration (GRBL's $11)
    blend,     ///< it rounds the corner by a parabola that leaves it by the tolerance at most (LinuxCNC's G64 P)
};

/// Which arcs a control takes. What is beyond has to be split or posted as lines.
struct ArcRules {
    double largestSweep = 2.0 * pi; ///< rad, of one block; a whole circle where it is 2 pi; 0: it takes no arcs
    double smallestRadius = 0.0;    ///< mm
    double largestRadius = 1e4;     ///< mm
    double radiusMismatch = 0.002;  ///< mm, between the radii at start and end
};

/// How the axes carry the tool (core/machine/kinematics.h).
enum class MachineKinematics : std::uint8_t {
    threeAxes ///< X, Y and Z carry an upright tool
};

/// s that a spindle is given to get to its speed.
inline constexpr double spindleStartTime = 3.0;

/// What a spindle gives at one speed for as long as a cut takes.
struct SpindlePoint {
    double speed = 0.0;  ///< 1/min
    double torque = 0.0; ///< N m
};

/// A machine and its control, plain data. resources/machines/<id>.json; core/machine/README.md says what each key
/// means.
struct MachineProfile {
    std::string id;
    std::string name;
    std::string source;                         ///< where the numbers come from, unless `sources` says otherwise
    std::map<std::string, std::string> sources; ///< by key of the file: where that number comes from
    std::string dialect;                        ///< id of the dialect that its control reads; empty: not stated
    glm::dvec3 travel{0.0};                     ///< mm along X, Y, Z
    double maximumFeed = 0.0;                   ///< mm/min, cutting
    double rapidFeed = 0.0;                     ///< mm/min
    glm::dvec3 axisRates{0.0};                  ///< mm/min, greatest of each axis; 0: the rapid feed (see axisRate)
    double minimumSpindleSpeed = 0.0;           ///< 1/min
    double maximumSpindleSpeed = 0.0;           ///< 1/min
    double spindlePower = 0.0;                  ///< W; 0: not stated
    std::vector<SpindlePoint> spindleTorque{};  ///< by rising speed; empty: not stated (see torqueAt)
    double acceleration = 0.0;                  ///< mm/s², of an axis that has none of its own; 0: without limit
    glm::dvec3 axisAccelerations{0.0};          ///< mm/s², of each axis; 0: `acceleration` (see axisAcceleration)
    glm::dvec3 axisJerks{0.0};                  ///< mm/s³, of each axis; 0: without limit
    double blocksPerSecond = 0.0;               ///< that the control carries out at most; 0: not stated
    double toolChangeSeconds = 0.0;             ///< s, from chip to chip
    double toolChangeHeight = 0.0;              ///< mm above the work offset's zero that is always safe to go to
    RapidMode rapids = RapidMode::synchronised;
    JunctionRule junctions = JunctionRule::blend;
    double junctionTolerance = 0.01; ///< mm; of `blend` where the program states none
    ArcRules arcs;
    /// What it can switch on; nothing: the profile does not say, so that the control's words decide.
    std::optional<std::vector<Coolant>> coolants{};
    int coordinateDecimals = 3;  ///< digits behind the point in mm
    int maximumLineLength = 255; ///< characters
    /// mm, machine frame: where the spindle parks for a tool change and at the end, first Z, then X and Y; nothing: not
    /// stated, so that it stays where the dialect leaves it.
    std::optional<glm::dvec3> home{};
    MachineKinematics kinematics = MachineKinematics::threeAxes; ///< the files have no key for it yet

    /// Whether the value of a key is somebody's estimate, by what its source says.
    bool isEstimate(const std::string& key) const {
        const auto own = sources.find(key);
        return burin::isEstimate(own != sources.end() ? own->second : source);
    }
    bool has(Coolant coolant) const noexcept {
        return coolant == Coolant::off || !coolants || std::ranges::find(*coolants, coolant) != coolants->end();
    }
    /// mm/min, the greatest rate of an axis (0, 1, 2).
    double axisRate(int axis) const noexcept { return axisRates[axis] > 0.0 ? axisRates[axis] : rapidFeed; }
    /// N m that the spindle gives at a speed; 0: not stated. Between two points its power goes in a straight line,
    /// which is exact for constant torque as for constant power; below the first its torque stays, above the last its
    /// power. @param speed 1/min, > 0
    double torqueAt(double speed) const noexcept {
        if (spindleTorque.empty()) return 0.0;
        if (speed <= spindleTorque.front().speed) return spindleTorque.front().torque;
        const auto above = std::ranges::lower_bound(spindleTorque, speed, {}, &SpindlePoint::speed);
        const SpindlePoint& low = *(above - 1);
        if (above == spindleTorque.end()) return low.torque * low.speed / speed;
        const double share = (speed - low.speed) / (above->speed - low.speed);
        return std::lerp(low.torque * low.speed, above->torque * above->speed, share) / speed;
    }
    /// W that the spindle gives at a speed, of its power and its torque the smaller; 0: not stated.
    /// @param speed 1/min, > 0
    double powerAt(double speed) const noexcept {
        const double ofTorque = torqueAt(speed) * 2.0 * pi * speed / secondsPerMinute;
        return spindlePower > 0.0 && ofTorque > 0.0 ? std::min(spindlePower, ofTorque)
                                                    : std::max(spindlePower, ofTorque);
    }
    /// mm/s², of an axis; 0: without limit.
    double axisAcceleration(int axis) const noexcept {
        return axisAccelerations[axis] > 0.0 ? axisAccelerations[axis] : acceleration;
    }
};

} // namespace burin
