// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/curve_deviation.h"
#include "core/path/shape_fit.h"

#include <vector>

namespace burin {

/// A stroke and the tube around it: both the recorded points and the curve's stay in it. Along the curve the law of
/// time may differ; that is no deviation.
class ShapeTube {
public:
    /// @param tips mm, recorded @param tolerance mm @param reach mm along the curve that the law of time may differ by
    ShapeTube(std::vector<glm::dvec3> tips, double tolerance, double reach);

    /// Draws the fit into the tube by giving weight to points that are outside of it, and asks it at each point.
    /// @return mm, as many as points; some may still be outside
    std::vector<glm::dvec3> drawIn(ShapeFit& fit, const Progress& progress) const;
    /// Which points are outside, or have a recorded point outside of the other curve.
    std::vector<bool> outside(std::span<const glm::dvec3> smoothed) const;
    /// What could not be drawn into the tube stays as it was recorded.
    void restoreOutside(std::vector<glm::dvec3>& smoothed, const Progress& progress) const;

private:
    std::vector<double> offsets(std::span<const glm::dvec3> smoothed) const;

    std::vector<glm::dvec3> tips_; // recorded, mm
    StrokeCurve curve_;
    double tolerance_, reach_; // mm; along the curve
};

} // namespace burin
