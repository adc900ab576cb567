// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/geometry/pose.h"
#include "core/geometry/upright.h"
#include "core/machine/axis_values.h"
#include "core/machine/machine_profile.h"

#include <memory>

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

/// The kinematics of a machine for programs of one setup; the caller owns them.
/// @param zero the program's zero, mm, setup frame
std::unique_ptr<const Kinematics> kinematicsOf(const MachineProfile& machine, const glm::dvec3& zero);

} // namespace burin
