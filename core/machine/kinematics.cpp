// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/machine/kinematics.h"

#include "core/base/numbers.h"

#include <cmath>

namespace burin {

Result<AxisValues> ThreeAxes::axesOf(const ToolPose& pose) const {
    if (!isUpright(pose.axis)) {
        const double tilt = std::atan2(std::hypot(pose.axis.x, pose.axis.y), pose.axis.z);
        return Error{ErrorCode::programLimit, "tilt of the tool axis",
                     formatFixed(tilt * 180.0 / pi, 6) + "°, limit 0°", ""};
    }
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
