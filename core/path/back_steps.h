// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/path/part_guard.h"
#include "core/path/polyline.h"

#include <span>
#include <vector>

namespace burin {

/// A back-step: the tool turns back by more than `backStepTurn`, and one of the two moves is shorter than
/// `longestBackStep`. A machine stutters there and leaves a mark; nothing is milled by it.
inline constexpr double backStepTurn = 155.0 * pi / 180.0; ///< rad
inline constexpr double longestBackStep = 0.1;             ///< mm

/// Whether the tool steps back where two straight moves meet.
bool isBackStep(const glm::dvec3& from, const glm::dvec3& at, const glm::dvec3& to) noexcept;

/// Takes back-steps out of a stroke of straight moves by leaving out points around them, as far as all points stay
/// within `tolerance` of the moves that are left and `allowed` lets the new moves be. Corners of arcs stay.
/// @param kept indices of the points that stand, ascending; those that go are taken out
/// @return how far points lie from the moves that replace theirs, mm
Deviation dropBackSteps(std::span<const StrokePoint> points, std::vector<std::size_t>& kept, double tolerance,
                        const ShortcutTest& allowed, const Progress& progress);

/// mm that a path may change by for the control not to be sent back and forth: what smoothing in time with its first
/// tolerance overshoots by where a stroke ends (0.03 mm to either side).
inline constexpr double backStepTolerance = 0.06;

/// The same in all strokes of a path, straight before it is linked, with `backStepTolerance`: what no edit before took
/// out. Moves keep the distance from the part that their stroke keeps.
Deviation dropBackSteps(PathUnderEdit& state, const PartGuard& guard, const Progress& progress);

} // namespace burin
