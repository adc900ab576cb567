// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/stroke.h"

namespace burin {

/// Appends a point to those of a stroke, and before it as many points on the straight move to it as are needed for a
/// spacing of at most `apart`, mm, > 0. They belong to the move that ends at the point, and to the moment at which it
/// begins.
void addDivided(std::vector<StrokePoint>& points, const StrokePoint& point, double apart);

} // namespace burin
