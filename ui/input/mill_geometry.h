// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/tool/tool.h"
#include "core/volume/runs/run_volume.h"
#include "ui/scene/sight.h"

#include <optional>

namespace burin {

/// mm between a hovering tool and what is under it.
inline constexpr double hoverClearance = 2.0;

/// Where a sight meets the horizontal plane z = `height`, mm. Nothing where it runs along the plane or away from it.
std::optional<glm::dvec3> onLevel(const Sight& sight, double height);

/// Height of the tip, mm, at which flutes, shank and holder clear everything by `hoverClearance` on the straight move
/// between two places (x, y). Never too low; too high by what lies within half a radius beyond the tool's reach.
/// Above the whole grid where its runs don't lie along z.
double clearTipHeight(const VolumeSnapshot& workpiece, const Cutter& cutter, const glm::dvec2& from,
                      const glm::dvec2& to);

/// Moved into the box in x and y, mm.
glm::dvec3 keptWithin(const Box& box, const glm::dvec3& place);

/// Where the tip of a stroke may be, mm: over the grid and a little beside it.
Box strokeReach(const VolumeSnapshot& workpiece, const Cutter& cutter);

/// Step of an arrow or page key as the user sees it, along the axis of the setup that comes nearest: Up leads away from
/// the viewer. Zero for other keys.
/// @param key a Qt::Key; @param lookingAlong unit, from the eye into the picture
glm::dvec3 keyStep(int key, const glm::dvec3& lookingAlong);

} // namespace burin
