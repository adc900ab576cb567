// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/apply.h"

#include <span>
#include <vector>

namespace burin {

/// A stroke as a curve, independent of its timing, to measure distances from another version of it.
class StrokeCurve {
public:
    /// @param reach mm along the curve by which the timing may differ
    StrokeCurve(std::span<const glm::dvec3> tips, double reach);

    /// Distance from a tip to the moves around a point of the stroke, mm; returns any value up to `enough` once a move
    /// is that near. Never understated, as only moves within `reach` along the curve are considered.
    double distance(const glm::dvec3& tip, std::size_t point, double enough) const noexcept;

private:
    std::vector<glm::dvec3> moving_; // without repeated positions
    std::vector<double> lengths_;    // mm, up to each of them
    std::vector<std::size_t> at_;    // index in `moving_`, of each point
    double reach_;                   // mm
};

/// The largest distance between two versions of a stroke as curves: the largest distance from a point of either to the
/// moves of the other. Never understated. @param before, after point by point the same stroke
Deviation curveDeviation(std::span<const glm::dvec3> before, std::span<const glm::dvec3> after, double reach);

} // namespace burin
