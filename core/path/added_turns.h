// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/path/stroke.h"

#include <span>
#include <vector>

namespace burin {

/// The turns and back-steps of a stroke, accumulated up to each of its points.
struct TurnCount {
    std::vector<double> turns; ///< rad
    std::vector<std::size_t> backSteps;

    /// @param detail mm, tolerance to which the stroke is simplified before its turns are counted
    TurnCount(std::span<const glm::dvec3> tips, double detail, const Progress& progress);
};

struct TurnLimits {
    double window = 0.0; ///< mm of the course over which turns are counted
    double detail = 0.0; ///< mm: bends within this tolerance do not count
};

/// Smoothing is meant to remove turns. Where it adds some, a stiff curve that is drawn around a corner swings before
/// and behind it, and the recorded stroke is the smoother one.
class AddedTurns {
public:
    /// Keeps references to both. @param course mm, of each point, non-decreasing
    AddedTurns(std::span<const glm::dvec3> recorded, std::span<const double> course, const TurnLimits& limits,
               const Progress& progress);

    /// Marks the middle of every interval as long as the window in which the smoothed stroke turns more, or steps back
    /// more often, than the recorded one. @param smoothed the tips, mm, point by point
    std::vector<bool> in(std::span<const glm::dvec3> smoothed, const Progress& progress) const;
    /// There `smoothed` becomes the recording again, blended over a window on either side, until no such interval
    /// remains.
    void undo(std::vector<glm::dvec3>& smoothed, const Progress& progress) const;

private:
    std::span<const glm::dvec3> recorded_; // mm
    std::span<const double> course_;
    TurnLimits limits_;
    TurnCount before_;
};

} // namespace burin
