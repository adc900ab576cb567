// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/stroke.h"

namespace burin {

/// Adds a point behind those of a stroke, and before it as many on the straight way to it that none are farther apart
/// than `apart`, mm, > 0. They belong to the move that ends at the point, and to the moment that it begins at.
void addDivided(std::vector<StrokePoint>& points, const StrokePoint& point, double apart);

} // namespace burin
