// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/stroke.h"

#include <span>
#include <vector>

namespace burin {

/// The offset curve of a polyline in plan, as described at Offset (surface_edits.h): in several pieces where it cannot
/// continue, in the direction of the polyline. Outside corners are rounded. Cost: its points times those of the
/// polyline.
/// @param distance mm, to the left; 0 gives the polyline
std::vector<std::vector<StrokePoint>> offsetInPlan(std::span<const StrokePoint> points, double distance);

} // namespace burin
