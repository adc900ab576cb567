// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/axis_map.h"
#include "core/device/stylus.h"
#include "core/haptics/workspace_mapping.h"
#include "core/job/milling_context.h"

#include <string>

namespace burin {

/// A connected device: what moves the tool, unless the mouse does.
struct HandDevice {
    StylusDescription description;
    WorkspaceMapping mapping; ///< to the workpiece
    AxisMap axisMap;          ///< what its buttons do
};

/// @param assignment of its axes that the user keeps, as StylusController::axisMap has it
HandDevice handDevice(const StylusDevice& device, const MillingContext& milling, const std::string& assignment);

} // namespace burin
