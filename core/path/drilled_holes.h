// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/path.h"

#include <vector>

namespace burin {

/// Makes plunges of a drill's moves straight down, and rapids of what it does in a hole that it has drilled: up to the
/// height that the link goes on at, and down again to `approach` above the hole's bottom. Only plumb moves in a hole
/// that the tool came down into from a rapid count, so nothing but the hole is passed. @param approach mm, > 0
void plungeAndReturn(std::vector<PathPoint>& points, double approach);

} // namespace burin
