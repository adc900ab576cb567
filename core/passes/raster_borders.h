// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/plan_region.h"

#include <vector>

namespace burin {

/// Borders of what is blocked, between places with room (> 0) and without: marching squares, with the blocked side to
/// the left. Where two blocked corners of a square face each other they are taken as joined. Rings in squares from the
/// first place. @param room columns x rows values; beyond them there is `beyond`, > 0
std::vector<PlanRing> bordersOf(const std::vector<double>& room, int columns, int rows, double beyond);

} // namespace burin
