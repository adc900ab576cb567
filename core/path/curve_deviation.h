// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/apply.h"

#include <span>
#include <vector>

namespace burin {

/// A stroke as a curve, whatever its law of time, to measure from another version of it.
class StrokeCurve {
public:
    /// @param reach mm along the curve that the law of time may differ by
    StrokeCurve(std::span<const glm::dvec3> tips, double reach);

    /// Distance from a tip to the moves around a point of the stroke, mm; any value up to `enough` once a move is as
    /// near as that. Never understated, as only moves within `reach` along the curve are looked at.
    double distance(const glm::dvec3& tip, std::size_t point, double enough) const noexcept;

private:
    std::vector<glm::dvec3> moving_; // without points that stand still
    std::vector<double> lengths_;    // mm, up to each of them
    std::vector<std::size_t> at_;    // of each point
    double reach_;                   // mm
};

/// How far two versions of a stroke lie apart as curves: of all points of either, the farthest from the other's moves.
/// Never understated. @param before, after point by point the same stroke
Deviation curveDeviation(std::span<const glm::dvec3> before, std::span<const glm::dvec3> after, double reach);

} // namespace burin
