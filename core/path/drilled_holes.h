// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/path.h"

#include <vector>

namespace burin {

/// Turns the downward moves of a drill into plunges, and its moves within a hole that it has already drilled into
/// rapids: up to the height at which the link continues, and down again to `approach` above the bottom of the hole.
/// Only vertical moves in a hole that the tool entered by a rapid from above qualify, so that nothing but the hole is
/// passed.
/// @param approach mm, > 0
void plungeAndReturn(std::vector<PathPoint>& points, double approach);

} // namespace burin
