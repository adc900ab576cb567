// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace burin {

/// A B-spline in plan, rational where it has weights.
struct RationalSpline {
    int degree = 3;
    std::vector<double> knots;        ///< as many as controls + degree + 1, never falling
    std::vector<glm::dvec2> controls; ///< mm
    std::vector<double> weights;      ///< > 0, one a control, or none
};

/// Whether numbers and order of knots, controls and weights make a curve.
bool isValid(const RationalSpline& spline) noexcept;
/// At a value between the knots of the degree's number from either end (de Boor). @param spline valid
glm::dvec2 pointOn(const RationalSpline& spline, double at);
/// Chords that were found within `chord` mm of it at their quarters and middles. @param spline valid
std::vector<glm::dvec2> flattened(const RationalSpline& spline, double chord);

} // namespace burin
