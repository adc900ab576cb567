// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/omission.h"
#include "core/path/stroke.h"

#include <cstddef>
#include <vector>

namespace burin {

/// A position of a stroke: at a share of the move that ends in one of its points. Its first point: {0, 1}.
struct StrokePosition {
    std::size_t move = 0;
    double share = 1.0; ///< 0 < … <= 1
};

/// A look at a stroke.
struct StrokeStep {
    StrokePosition position;
    glm::dvec3 tip{0.0}; ///< mm
    double at = 0.0;     ///< mm from the stroke's start, along it
};

/// Looks at a stroke no farther apart than `longest` mm, both ends and all points among them; none of no points.
std::vector<StrokeStep> stepsOf(const PathStroke& stroke, double longest);

/// The stroke from one position on it to a later one, on its very lines and arcs.
PathStroke between(const PathStroke& stroke, const StrokePosition& from, const StrokePosition& to);

/// mm, of the move that ends in a point, along its line or arc.
double lengthTo(const StrokePoint& point, const glm::dvec3& from);
/// mm, along lines and arcs.
double lengthOf(const PathStroke& stroke);

/// What is reported of a stroke that is left out. @param stroke of at least one point
Omission omissionOf(const PathStroke& stroke, OmissionReason reason);

} // namespace burin
