// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/omission.h"
#include "core/path/stroke.h"

#include <cstddef>
#include <vector>

namespace burin {

/// A position on a stroke: at a fraction of the move that ends at one of its points. Its first point: {0, 1}.
struct StrokePosition {
    std::size_t move = 0;
    double share = 1.0; ///< 0 < … <= 1
};

/// A sample of a stroke.
struct StrokeStep {
    StrokePosition position;
    glm::dvec3 tip{0.0}; ///< mm
    double at = 0.0;     ///< mm from the stroke's start, along it
};

/// Samples of a stroke no farther apart than `longest` mm, including both ends and all points; empty if it has no
/// points.
std::vector<StrokeStep> stepsOf(const PathStroke& stroke, double longest);

/// The stroke from one position on it to a later one, exactly on its lines and arcs.
PathStroke between(const PathStroke& stroke, const StrokePosition& from, const StrokePosition& to);

/// The length of the move that ends at a point, along its line or arc, mm.
double lengthTo(const StrokePoint& point, const glm::dvec3& from);
/// The length along lines and arcs, mm.
double lengthOf(const PathStroke& stroke);

/// The report of a stroke that is left out. @param stroke of at least one point
Omission omissionOf(const PathStroke& stroke, OmissionReason reason);

} // namespace burin
