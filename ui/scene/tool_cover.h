// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"
#include "core/tool/tool.h"
#include "ui/scene/camera_view.h"

namespace burin {

/// How much of what lies round the tip is hidden from the eye by shank and holder. The flutes don't count: they show
/// where the tool is.
/// @return 0 … 1
double coveredShare(const Cutter& cutter, const ToolPose& pose, const CameraView& view);

} // namespace burin
