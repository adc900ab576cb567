// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/machine/kinematics.h"

#include "core/base/numbers.h"

#include <cmath>

namespace burin {

namespace {

/// A tool is upright that leans by no more, rad: what turning a frame there and back leaves of an axis. It moves a
/// point 200 mm above the tip by 0.000002 mm.
constexpr double upright = 1e-8;

} // namespace

Result<AxisValues> ThreeAxes::axesOf(const ToolPose& pose) const {
    const double tilt = std::atan2(std::hypot(pose.axis.x, pose.axis.y), pose.axis.z);
    if (!(tilt <= upright))
        return Error{ErrorCode::programLimit, "tilt of the tool axis",
                     formatFixed(tilt * 180.0 / pi, 6) + "°, limit 0°", ""};
    return AxisValues(pose.tip - zero_);
}

std::unique_ptr<const Kinematics> kinematicsOf(const MachineProfile& machine, const glm::dvec3& zero) {
    switch (machine.kinematics) {
    case MachineKinematics::threeAxes:
        break;
    }
    return std::make_unique<ThreeAxes>(zero);
}

} // namespace burin
