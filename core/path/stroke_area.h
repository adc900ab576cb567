// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/area.h"
#include "core/path/stroke.h"

namespace burin {

/// A stroke with points inserted where it crosses an area's border, and for each point whether the move that ends there
/// lies in the area; for the first one, whether the point itself does.
struct DividedStroke {
    std::vector<StrokePoint> points;
    std::vector<bool> inside;
};
DividedStroke divide(const PathStroke& stroke, const Area& area);

} // namespace burin
