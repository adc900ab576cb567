// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/arc.h"
#include "core/path/apply.h"

#include <optional>
#include <span>

namespace burin {

/// What an arc has to obey.
struct ArcFitRules {
    double tolerance = 0.01;     ///< mm
    double largestSweep = 0.0;   ///< rad, at most half a turn
    double smallestRadius = 0.0; ///< mm
    double largestRadius = 0.0;  ///< mm
    double radiusMismatch = 0.0; ///< mm, between the radii at both ends once figures are rounded
    double figure = 0.001;       ///< mm, step of the control's coordinates
    glm::dvec3 programZero{0.0}; ///< mm, from where they are counted
};

/// An arc that stands for a stretch of a stroke.
struct FittedArc {
    Arc arc;
    Deviation deviation; ///< never understated
};

/// The place on the grid of figures around `centre` from where both ends, as the control gets them, are most nearly
/// equally far; all in the arc's plane. Nothing where none is good enough.
std::optional<glm::dvec2> roundedCentre(const glm::dvec2& centre, const glm::dvec2& from, const glm::dvec2& to,
                                        const glm::dvec2& zero, const ArcFitRules& rules);

/// The arc or helix about an axis of the frame from the first point to the last that the points between lie nearest to
/// (its centre on the bisector of both ends, as far outside as inside), with its centre on the grid of the control's
/// figures. Nothing where that breaks a rule.
///
/// The deviation holds both ways, for the whole polyline and the whole arc: seen from the centre, vertices go round in
/// order, so that every place of one has a place of the other at its angle. Between two vertices the radius is least at
/// the foot of the perpendicular; along the axis a chord leaves the even climb by no more than 0.08 h² of its own
/// climb, h half of the angle it spans (at most 30°), and a quarter of its relative change of radius.
std::optional<FittedArc> fitArc(std::span<const StrokePoint> points, int axis, const ArcFitRules& rules);

} // namespace burin
