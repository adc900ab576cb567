// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"
#include "core/geometry/triangle_tree.h"
#include "core/tool/tool.h"
#include "ui/scene/camera_view.h"

namespace burin {

/// Where a tool cuts, or would: what lies round its tip is to be seen.
struct CutPlace {
    ToolPose pose;       ///< setup frame, mm
    double radius = 0.0; ///< of the cutter, mm
};

/// How much of what lies round the tip is hidden from the eye by shank and holder. The flutes don't count: they show
/// where the tool is.
/// @return 0 … 1
double coveredShare(const Cutter& cutter, const ToolPose& pose, const CameraView& view);

/// How much of what lies round a tip is hidden from the eye by a closed solid. What lies in the solid doesn't count:
/// there is nothing to be seen.
/// @return 0 … 1. Cost: some microseconds for each of a few dozen sights
double coveredShare(const TriangleTree& solid, const CutPlace& cut, const CameraView& view);

/// Of what hides a share (0 … 1) of a cut: solid (1) where that is little, a trace of itself where it is half or more.
double opacityOver(double coveredShare);

} // namespace burin
