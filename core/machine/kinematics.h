// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/geometry/pose.h"
#include "core/geometry/upright.h"
#include "core/machine/axis_values.h"
#include "core/machine/machine_profile.h"

#include <memory>
#include <span>
#include <vector>

namespace burin {

/// How the axes of a machine move a tool relative to a setup. All conversions between poses and axis values are made
/// here. Axis values are those of the program, relative to the zero that the kinematics were made for. Immutable;
/// thread-safe.
class Kinematics {
public:
    virtual ~Kinematics() = default;

    /// The axes that a pose depends on.
    virtual AxisSet axes() const noexcept = 0;
    /// The axis values for a tool pose.
    /// @param pose setup frame; finite, its axis of unit length
    /// Errors: programLimit (the machine can't orient the tool like this). Axis limits are checked by AxisTravel.
    virtual Result<AxisValues> axesOf(const ToolPose& pose) const = 0;
    /// The same; of several possible values the ones nearest to those before: rotary axes don't turn back by a turn,
    /// and a rotary axis whose value does not matter at this pose keeps it.
    virtual Result<AxisValues> axesNear(const ToolPose& pose, const AxisValues& before) const;
    /// The axes whose value does not matter at a pose: the one that turns about the tool.
    virtual AxisSet freeAxes(const ToolPose& pose) const noexcept;
    /// The tool's pose, setup frame. Axes that the machine doesn't have are ignored.
    virtual ToolPose poseOf(const AxisValues& values) const noexcept = 0;
};

/// X, Y and Z move an upright tool: the values are the position of the tip relative to the program's zero.
class ThreeAxes final : public Kinematics {
public:
    /// @param zero the program's zero, mm, setup frame
    explicit ThreeAxes(const glm::dvec3& zero = glm::dvec3(0.0)) noexcept : zero_(zero) {}

    AxisSet axes() const noexcept override { return linearAxes; }
    Result<AxisValues> axesOf(const ToolPose& pose) const override;
    ToolPose poseOf(const AxisValues& values) const noexcept override { return {values.linear() + zero_, uprightAxis}; }

private:
    glm::dvec3 zero_;
};

/// X, Y and Z move the tip, one or two rotary axes tilt the tool; the control keeps the tip where X, Y and Z state it
/// on the workpiece (tool centre point control, RTCP), so that the values don't depend on where the axes of rotation
/// are.
class TiltingAxes final : public Kinematics {
public:
    /// @param rotary as MachineProfile::rotaryAxes, not empty @param zero the program's zero, mm, setup frame
    TiltingAxes(std::vector<RotaryAxis> rotary, const glm::dvec3& zero);

    AxisSet axes() const noexcept override;
    Result<AxisValues> axesOf(const ToolPose& pose) const override { return axesNear(pose, AxisValues()); }
    Result<AxisValues> axesNear(const ToolPose& pose, const AxisValues& before) const override;
    AxisSet freeAxes(const ToolPose& pose) const noexcept override;
    ToolPose poseOf(const AxisValues& values) const noexcept override;

private:
    std::vector<RotaryAxis> rotary_;
    glm::dvec3 zero_;
};

/// A pose, and how the tool gets there.
struct CoursePose {
    enum class By : std::uint8_t { rapid, line, arc };
    ToolPose pose; ///< setup frame
    By by = By::line;
};
/// The values of a machine's axes along a series of poses, without needless turns: while a rotary axis does not matter,
/// because the tool is parallel to it, it turns to where it is needed next, in the last rapid before that, else evenly
/// on straight moves. @param before the values at the start
/// Errors: those of Kinematics::axesNear; detail: "point " and the index of the pose.
Result<std::vector<AxisValues>> axesAlong(const Kinematics& kinematics, std::span<const CoursePose> poses,
                                          const AxisValues& before);

/// The kinematics of a machine for programs of one setup; the caller owns them.
/// @param zero the program's zero, mm, setup frame
std::unique_ptr<const Kinematics> kinematicsOf(const MachineProfile& machine, const glm::dvec3& zero);

} // namespace burin
