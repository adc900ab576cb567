// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/arc.h"
#include "core/path/path.h"
#include "ui/input/path_hand.h"

#include <functional>
#include <vector>

namespace burin {

/// The arc of the move to a point that has one. @param from start of the move, mm
Arc arcOf(const glm::dvec3& from, const PathPoint& to);

/// The point at a position on a path, mm, setup frame.
glm::dvec3 placeOf(const std::vector<PathPoint>& points, const PathPlace& place);

/// The fraction of a displacement that a point gets at a distance along the path from the one that is dragged, mm.
using DragShare = std::function<double(double distance)>;

/// The shape of a path while one of its points is dragged, mm, setup frame: the displacement decreases along the part
/// that comes from the same source without a gap, up to `reach`, mm.
std::vector<glm::dvec3> draggedShape(const std::vector<PathPoint>& points, const PathPlace& place, const glm::dvec3& by,
                                     double reach, const DragShare& shareAt);

} // namespace burin
