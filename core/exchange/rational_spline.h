// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace burin {

/// A B-spline in plan, rational if it has weights.
struct RationalSpline {
    int degree = 3;
    std::vector<double> knots;        ///< size: controls + degree + 1, non-decreasing
    std::vector<glm::dvec2> controls; ///< mm
    std::vector<double> weights;      ///< > 0, one per control point, or empty
};

/// Whether the sizes and the order of knots, control points and weights define a curve.
bool isValid(const RationalSpline& spline) noexcept;
/// The point at a parameter between the knots with index `degree` from either end (de Boor). @param spline valid
glm::dvec2 pointOn(const RationalSpline& spline, double at);
/// Chords within `chord` mm of the curve, checked at their quarters and middles. @param spline valid
std::vector<glm::dvec2> flattened(const RationalSpline& spline, double chord);

} // namespace burin
