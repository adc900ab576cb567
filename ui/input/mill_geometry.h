// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/tool/tool.h"
#include "core/volume/runs/run_volume.h"
#include "ui/scene/sight.h"

#include <optional>

namespace burin {

/// Clearance between a hovering tool and what is under it, mm.
inline constexpr double hoverClearance = 2.0;

/// The intersection of a line of sight with the horizontal plane z = `height`, mm. Empty if the line is parallel to the
/// plane or leads away from it.
std::optional<glm::dvec3> onLevel(const Sight& sight, double height);

/// Tip height, mm, at which flutes, shank and holder clear everything by `hoverClearance` on the straight move between
/// two points (x, y). Never too low; may be too high because of obstacles up to half a radius beyond the tool's reach.
/// Above the complete grid if its runs are not along z.
double clearTipHeight(const VolumeSnapshot& workpiece, const Cutter& cutter, const glm::dvec2& from,
                      const glm::dvec2& to);

/// The point, clamped to the box in x and y, mm.
glm::dvec3 keptWithin(const Box& box, const glm::dvec3& place);

/// Allowed tip positions of a stroke, mm: the grid and a margin around it.
Box strokeReach(const VolumeSnapshot& workpiece, const Cutter& cutter);

/// Step of an arrow or page key as seen by the user, along the nearest axis of the setup: Up leads away from the
/// viewer. Zero for other keys.
/// @param key a Qt::Key; @param lookingAlong unit, from the eye into the picture
glm::dvec3 keyStep(int key, const glm::dvec3& lookingAlong);

} // namespace burin
