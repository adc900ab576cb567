// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/machine/kinematics.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace burin {
namespace {

constexpr double degrees = 180.0 / pi;
/// Below this sine of the angle between tool and axis, the axis turns about the tool (as for isUpright).
constexpr double parallel = 1e-6;
/// Values this far beyond a limit are rounding, degrees.
constexpr double onLimit = 1e-9;

Error tiltError(const ToolPose& pose, const std::string& limit) {
    const double tilt = std::atan2(std::hypot(pose.axis.x, pose.axis.y), pose.axis.z);
    return {ErrorCode::programLimit, "tilt of the tool axis", formatFixed(tilt * degrees, 6) + "°, limit " + limit, ""};
}

/// The component (0 X, 1 Y, 2 Z) that a rotary axis turns about.
int componentOf(Axis axis) noexcept {
    return static_cast<int>(axis) - static_cast<int>(Axis::a);
}

/// Turned right-handed about X, Y or Z.
glm::dvec3 turned(const glm::dvec3& v, int about, double angle) noexcept {
    const int u = (about + 1) % 3, w = (about + 2) % 3;
    const double sine = std::sin(angle), cosine = std::cos(angle);
    glm::dvec3 result = v;
    result[u] = cosine * v[u] - sine * v[w];
    result[w] = sine * v[u] + cosine * v[w];
    return result;
}

/// Right-handed angles of the axes, rad, as RotaryAxis::reversed = false counts them.
using Angles = std::array<double, 2>;

/// Both solutions for two axes, of which the second one is A or B and the first one is another axis: the tool's
/// direction is that of Z, turned about the second axis, then about the first. The same ones for a single axis.
std::array<Angles, 2> solve(const glm::dvec3& axis, int first, int second) noexcept {
    if (first == 2) { // (sin c sin a, -cos c sin a, cos a), (cos c sin b, sin c sin b, cos b)
        const double tilt = std::atan2(std::hypot(axis.x, axis.y), axis.z);
        const double turn = second == 0 ? std::atan2(axis.x, -axis.y) : std::atan2(axis.y, axis.x);
        return {Angles{turn, tilt}, Angles{turn + pi, -tilt}};
    }
    const double near = second == 0 ? -axis.y : axis.x, across = second == 0 ? axis.x : -axis.y;
    const double tilt = std::asin(std::clamp(near, -1.0, 1.0)), turn = std::atan2(across, axis.z);
    return {Angles{turn, tilt}, Angles{turn + pi, pi - tilt}};
}

/// The value of a rotary axis for an angle, within its limits and nearest to another value; empty if there is none.
std::optional<double> valueNear(const RotaryAxis& axis, double angle, double before) {
    double value = (axis.reversed ? -angle : angle) * degrees;
    value += 360.0 * std::round((before - value) / 360.0);
    if (value < axis.low - onLimit) value += 360.0 * std::ceil((axis.low - onLimit - value) / 360.0);
    if (value > axis.high + onLimit) value -= 360.0 * std::ceil((value - axis.high - onLimit) / 360.0);
    if (value < axis.low - onLimit || value > axis.high + onLimit) return std::nullopt;
    return value;
}

std::string limitsOf(std::span<const RotaryAxis> rotary) {
    std::string text;
    for (const RotaryAxis& axis : rotary) {
        if (!std::isfinite(axis.low) && !std::isfinite(axis.high)) continue;
        text += (text.empty() ? "" : ", ") + std::string(1, letterOf(axis.axis)) + " " + formatShortest(axis.low) +
                " to " + formatShortest(axis.high) + "°";
    }
    return text.empty() ? std::string("0°") : text;
}

/// Turns an axis that does not matter at the last values, from `first` on, to where it is needed behind them.
void turnBefore(std::span<const CoursePose> poses, std::size_t first, Axis axis, double to, double from,
                std::vector<AxisValues>& values) {
    std::optional<std::size_t> rapid;
    std::size_t lines = 0;
    for (std::size_t k = first; k < values.size(); ++k) {
        if (poses[k].by == CoursePose::By::rapid || k == 0) rapid = k;
        if (poses[k].by == CoursePose::By::line) ++lines;
    }
    std::size_t line = 0;
    for (std::size_t k = first; k < values.size(); ++k) {
        if (poses[k].by == CoursePose::By::line) ++line;
        const double share = lines > 0 ? static_cast<double>(line) / static_cast<double>(lines) : 0.0;
        values[k].set(axis, rapid ? (k < *rapid ? from : to) : std::lerp(from, to, share));
    }
}

} // namespace

Result<AxisValues> Kinematics::axesNear(const ToolPose& pose, const AxisValues& /*before*/) const {
    return axesOf(pose);
}

AxisSet Kinematics::freeAxes(const ToolPose& /*pose*/) const noexcept {
    return {};
}

Result<AxisValues> ThreeAxes::axesOf(const ToolPose& pose) const {
    if (!isUpright(pose.axis)) return tiltError(pose, "0°");
    return AxisValues(pose.tip - zero_);
}

TiltingAxes::TiltingAxes(std::vector<RotaryAxis> rotary, const glm::dvec3& zero)
    : rotary_(std::move(rotary)), zero_(zero) {}

AxisSet TiltingAxes::axes() const noexcept {
    AxisSet axes = linearAxes;
    for (const RotaryAxis& axis : rotary_) axes.set(axis.axis);
    return axes;
}

AxisSet TiltingAxes::freeAxes(const ToolPose& pose) const noexcept {
    if (rotary_.size() < 2) return {};
    glm::dvec3 about(0.0);
    about[componentOf(rotary_.front().axis)] = 1.0;
    return glm::length(glm::cross(about, pose.axis)) < parallel ? AxisSet(rotary_.front().axis) : AxisSet();
}

Result<AxisValues> TiltingAxes::axesNear(const ToolPose& pose, const AxisValues& before) const {
    const int second = componentOf(rotary_.back().axis);
    const int first = rotary_.size() > 1 ? componentOf(rotary_.front().axis) : 1 - second;
    const bool alone = rotary_.size() == 1;
    std::optional<AxisValues> best;
    double least = std::numeric_limits<double>::infinity();
    for (Angles angles : solve(pose.axis, first, second)) {
        if (freeAxes(pose).has(rotary_.front().axis))
            angles[0] = before[rotary_.front().axis] / degrees * (rotary_.front().reversed ? -1.0 : 1.0);
        if (alone && std::abs(std::remainder(angles[0], 2.0 * pi)) > parallel) continue;
        AxisValues values(pose.tip - zero_);
        double way = 0.0;
        bool within = true;
        for (std::size_t i = 0; i < rotary_.size() && within; ++i) {
            const RotaryAxis& axis = rotary_[i];
            const std::optional<double> value = valueNear(axis, angles[alone ? 1 : i], before[axis.axis]);
            within = value.has_value();
            if (!within) break;
            values.set(axis.axis, *value);
            way += std::abs(*value - before[axis.axis]);
        }
        if (!within || !(way < least)) continue;
        least = way;
        best = std::move(values);
    }
    if (!best) return tiltError(pose, limitsOf(rotary_));
    return std::move(*best);
}

ToolPose TiltingAxes::poseOf(const AxisValues& values) const noexcept {
    glm::dvec3 axis = uprightAxis;
    for (std::size_t i = rotary_.size(); i-- > 0;) {
        const RotaryAxis& rotary = rotary_[i];
        const double angle = values[rotary.axis] / degrees;
        axis = turned(axis, componentOf(rotary.axis), rotary.reversed ? -angle : angle);
    }
    return {values.linear() + zero_, axis};
}

Result<std::vector<AxisValues>> axesAlong(const Kinematics& kinematics, std::span<const CoursePose> poses,
                                          const AxisValues& before) {
    std::vector<AxisValues> all;
    all.reserve(poses.size());
    std::size_t free = 0; // the poses from here on, at the end of `all`, leave an axis free
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const ToolPose& pose = poses[i].pose;
        Result<AxisValues> values = kinematics.axesNear(pose, all.empty() ? before : all.back());
        if (!values) {
            Error error = std::move(values).error();
            error.detail = "point " + std::to_string(i);
            return error;
        }
        if (kinematics.freeAxes(pose).empty()) {
            if (free < i)
                for (const Axis axis : kinematics.freeAxes(poses[i - 1].pose))
                    turnBefore(poses, free, axis, (*values)[axis], free > 0 ? all[free - 1][axis] : before[axis], all);
            free = i + 1;
        }
        all.push_back(std::move(*values));
    }
    return all;
}

std::unique_ptr<const Kinematics> kinematicsOf(const MachineProfile& machine, const glm::dvec3& zero) {
    if (machine.tilts()) return std::make_unique<TiltingAxes>(machine.rotaryAxes, zero);
    return std::make_unique<ThreeAxes>(zero);
}

} // namespace burin
