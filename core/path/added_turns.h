// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/path/stroke.h"

#include <span>
#include <vector>

namespace burin {

struct TurnLimits {
    double window = 0.0; ///< mm of the course that turns are counted over
    double detail = 0.0; ///< mm: bends that stay within it are none
};

/// Smoothing takes turns away. Where it adds some (a stiff curve that is drawn around a corner swings before and behind
/// it), the recorded stroke is the smoother one: there `smoothed` becomes what was recorded, blended over a window on
/// either side, until no stretch as long as a window turns more than the recorded one does, nor steps back more often.
/// @param course mm, of each point, never falling @param smoothed the tips, mm, point by point
void undoAddedTurns(std::span<const StrokePoint> recorded, std::span<const double> course, const TurnLimits& limits,
                    std::vector<glm::dvec3>& smoothed, const Progress& progress);

} // namespace burin
