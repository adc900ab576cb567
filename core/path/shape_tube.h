// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/curve_deviation.h"
#include "core/path/shape_fit.h"

#include <vector>

namespace burin {

/// A stroke and the tube of the tolerance around it: both the recorded points and those of the curve have to stay in
/// it. The timing along the curve may differ; that is no deviation.
class ShapeTube {
public:
    /// @param tips mm, recorded @param tolerance mm @param reach mm along the curve by which the timing may differ
    ShapeTube(std::vector<glm::dvec3> tips, double tolerance, double reach);

    /// Pulls the fit into the tube by increasing the weight of points outside it, and evaluates it at each point.
    /// @return mm, one per point; some may still be outside
    std::vector<glm::dvec3> drawIn(ShapeFit& fit, const Progress& progress) const;
    /// Which points are outside, or have a recorded point outside the tube of the other curve.
    std::vector<bool> outside(std::span<const glm::dvec3> smoothed) const;
    /// Restores the recording where the curve could not be pulled into the tube.
    void restoreOutside(std::vector<glm::dvec3>& smoothed, const Progress& progress) const;

private:
    std::vector<double> offsets(std::span<const glm::dvec3> smoothed) const;

    std::vector<glm::dvec3> tips_; // recorded, mm
    StrokeCurve curve_;
    double tolerance_, reach_; // mm; along the curve
};

} // namespace burin
