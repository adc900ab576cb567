// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/plan_region.h"

#include <vector>

namespace burin {

/// The borders of what is blocked, between grid points with room (> 0) and without: marching squares, with the blocked
/// side to the left. In a square where two blocked corners are diagonally opposite they count as joined. Ring
/// coordinates are in squares from the first grid point. @param room columns x rows values; outside the grid the value
/// is `beyond`, > 0
std::vector<PlanRing> bordersOf(const std::vector<double>& room, int columns, int rows, double beyond);

} // namespace burin
