// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"
#include "core/geometry/triangle_tree.h"
#include "core/tool/tool.h"
#include "ui/scene/camera_view.h"

namespace burin {

/// The position where a tool cuts, or would cut: the surroundings of its tip should be visible.
struct CutPlace {
    ToolPose pose;       ///< setup frame, mm
    double radius = 0.0; ///< of the cutter, mm
};

/// The fraction of the tip's surroundings that shank and holder hide from the eye. The flutes don't count: they show
/// where the tool is.
/// @return 0 … 1
double coveredShare(const Cutter& cutter, const ToolPose& pose, const CameraView& view);

/// The fraction of a tip's surroundings that a closed solid hides from the eye. Points inside the solid don't count:
/// there is nothing to be seen.
/// @return 0 … 1. Cost: some microseconds for each of a few dozen sight lines
double coveredShare(const TriangleTree& solid, const CutPlace& cut, const CameraView& view);

/// The opacity of an object that hides a fraction (0 … 1) of a cut: solid (1) if the fraction is small, almost
/// transparent if it is half or more.
double opacityOver(double coveredShare);

} // namespace burin
