// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/back_steps.h"
#include "core/path/stroke_steps.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace burin {

/// Length from which moves on either side of a turn are no back-step, even after rounding in a program in inches.
inline constexpr double turnRoom = 1.1 * longestBackStep; // mm

/// The point beyond the end of a line, at the same level, where a tool that comes back along the line turns if the last
/// move of the line is too short to turn on. Empty: it turns at the end itself. @param before the corner before the
/// end, mm
std::optional<glm::dvec3> turnBeyond(const glm::dvec3& end, const glm::dvec3& before);

/// A stroke whose first move is long enough to turn on: points behind the first one are left out if they are within
/// `backStepTolerance` of the move that replaces them. Empty if that is not possible, or not clear of the part.
/// @param deviation receives their largest distance from it
std::optional<PathStroke> withLongStart(const PathStroke& stroke, const PartGuard& guard, Deviation& deviation);

/// The beginning of a line that is followed back and forth: up to the first of its steps, from `wanted` on, whose move
/// is long enough to turn on; if there is none, its last straight move is extended as needed.
/// @param steps of the line; those up to `usable` may be used @param wanted <= usable
PathStroke turnable(const PathStroke& line, const std::vector<StrokeStep>& steps, std::size_t wanted,
                    std::size_t usable);

} // namespace burin
