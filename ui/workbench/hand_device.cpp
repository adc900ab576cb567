// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/hand_device.h"

#include "core/device/axis_map_json.h"
#include "core/job/milling.h"

namespace burin {

HandDevice handDevice(const StylusDevice& device, const MillingContext& milling, const std::string& assignment) {
    const StylusDescription description = device.description();
    const MappableDevice mappable = mappableOf(device);
    const Result<AxisMap> kept = axisMapFromJson(assignment, mappable);
    // A wrong assignment did not let the device connect.
    return {description, mappingFor(milling, description), kept ? *kept : mappable.usual};
}

} // namespace burin
