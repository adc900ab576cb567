// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/back_steps.h"
#include "core/path/stroke_steps.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace burin {

/// Moves on either side of a turn that are no back-step, also with the figures of a program in inches.
inline constexpr double turnRoom = 1.1 * longestBackStep; // mm

/// Where a tool that comes back to the end of a line turns: level beyond it, where the line's last move is too short to
/// turn on. Nothing: it turns in the end itself. @param before the corner before it, mm
std::optional<glm::dvec3> turnBeyond(const glm::dvec3& end, const glm::dvec3& before);

/// A stroke with a first move that is long enough to turn on: points behind the first one are left out, no farther than
/// `backStepTolerance` from the move in their stead. Nothing where that is not possible, or not clear of the part.
/// @param deviation takes how far they lie from it
std::optional<PathStroke> withLongStart(const PathStroke& stroke, const PartGuard& guard, Deviation& deviation);

/// The beginning of a line that is gone to and fro: up to the first of its steps, from `wanted` on, whose move is long
/// enough to turn on; where there is none its last straight move is drawn out so far.
/// @param steps of the line; those up to `usable` may be gone @param wanted <= usable
PathStroke turnable(const PathStroke& line, const std::vector<StrokeStep>& steps, std::size_t wanted,
                    std::size_t usable);

} // namespace burin
