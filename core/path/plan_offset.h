// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/stroke.h"

#include <span>
#include <vector>

namespace burin {

/// The curve beside a polyline in plan, as Offset (surface_edits.h) has it: in pieces where it can't go on, in the
/// direction of the polyline. Corners on the outside are rounded. Cost: its points times those of the polyline.
/// @param distance mm, to the left; 0 gives the polyline
std::vector<std::vector<StrokePoint>> offsetInPlan(std::span<const StrokePoint> points, double distance);

} // namespace burin
