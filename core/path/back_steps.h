// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/path/part_guard.h"
#include "core/path/polyline.h"

#include <span>
#include <vector>

namespace burin {

/// A back-step: the tool reverses its direction by more than `backStepTurn`, and one of the two moves is shorter than
/// `longestBackStep`. A machine stutters there and leaves a mark without milling anything.
inline constexpr double backStepTurn = 155.0 * pi / 180.0; ///< rad
inline constexpr double longestBackStep = 0.1;             ///< mm

/// Whether the corner between two straight moves is a back-step.
bool isBackStep(const glm::dvec3& from, const glm::dvec3& at, const glm::dvec3& to) noexcept;

/// Removes back-steps from a stroke of straight moves by leaving out points around them, as long as all points stay
/// within `tolerance` of the remaining moves and `allowed` accepts the new moves. Corners of arcs stay.
/// @param kept indices of the remaining points, ascending; those that are left out are erased
/// @return the largest distance from a point to the move that replaces it, mm
Deviation dropBackSteps(std::span<const StrokePoint> points, std::vector<std::size_t>& kept, double tolerance,
                        const ShortcutTest& allowed, const Progress& progress);

/// mm, by which a path may change so that the control is not sent back and forth: the overshoot of smoothing in time
/// with its first tolerance where a stroke ends (0.03 mm to either side).
inline constexpr double backStepTolerance = 0.06;

/// Removes, with `backStepTolerance`, the back-steps that earlier edits left in the strokes of a path, right before it
/// is linked. The new moves keep the distance from the part that their stroke keeps.
Deviation dropBackSteps(PathUnderEdit& state, const PartGuard& guard, const Progress& progress);

} // namespace burin
