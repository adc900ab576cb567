// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/arc.h"
#include "core/path/apply.h"

#include <optional>
#include <span>

namespace burin {

/// Conditions that an arc has to meet.
struct ArcFitRules {
    double tolerance = 0.01;     ///< mm
    double largestSweep = 0.0;   ///< rad, at most half a turn
    double smallestRadius = 0.0; ///< mm
    double largestRadius = 0.0;  ///< mm
    double radiusMismatch = 0.0; ///< mm, between the radii at both ends after rounding to the control's number grid
    double figure = 0.001;       ///< mm, increment of the control's coordinates
    glm::dvec3 programZero{0.0}; ///< mm, origin of the control's coordinates
};

/// An arc that replaces part of a stroke.
struct FittedArc {
    Arc arc;
    Deviation deviation; ///< never understated
};

/// The point near `centre` on the control's number grid whose distances from both ends, as the control reads them, are
/// most nearly equal; all in the plane of the arc. Empty if none is good enough.
std::optional<glm::dvec2> roundedCentre(const glm::dvec2& centre, const glm::dvec2& from, const glm::dvec2& to,
                                        const glm::dvec2& zero, const ArcFitRules& rules);

/// The arc or helix about an axis of the frame, from the first point to the last, that fits the points between them
/// best: its centre lies on the bisector of both ends, with the deviations outside and inside balanced, and on the
/// control's number grid. Empty if that breaks a rule.
///
/// The deviation holds both ways, for the whole polyline and the whole arc: seen from the centre, the vertices follow
/// each other in order, so that every point of one has a point of the other at its angle. Between two vertices the
/// radius is least at the foot of the perpendicular; along the axis a chord leaves the even climb by no more than
/// 0.08 h² of its own climb, where h is half of the angle that it spans (at most 30°), and a quarter of its relative
/// change of radius.
std::optional<FittedArc> fitArc(std::span<const StrokePoint> points, int axis, const ArcFitRules& rules);

} // namespace burin
