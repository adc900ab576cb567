// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_values.h"

namespace burin {

// Edits that depend on the part, and those that simplify the result, in any order.

/// Pushes every point of the path out of the part, grown by the take's allowance plus `clearance`: by the closest point
/// on the fine mesh, at the points and every `sampling` between them, more finely where a corner may be cut. Points
/// that carry no shape (0.002 mm) are dropped first. Afterwards every point of every move within a stroke keeps at
/// least the allowance. Points that are not pushed out within a few steps are lifted along the tool axis.
struct HoldOut {
    double clearance = 0.005; ///< mm
    double sampling = 0.1;    ///< mm
};
EditResult apply(const HoldOut& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Keeps the fewest points such that no dropped one is farther than `tolerance` from the result (Douglas & Peucker,
/// distance to segments). Never lets a segment enter the part: such a shortcut is not taken.
struct Simplify {
    double tolerance = 0.01; ///< mm
};
EditResult apply(const Simplify& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Projects strokes onto the part, grown by `allowance`: the tool comes down along its axis from above the part, or
/// moves along the gradient of the distance, until it touches; exact on the mesh, at points at most `sampling` apart.
/// Then the stroke is kept out of the part with that allowance as by HoldOut, including the moves between the points.
/// Where there is nothing below, down to the floor of the stock, or the gradient leads nowhere, the stroke ends;
/// another one begins behind. Steps downwards are at least 0.02 mm: features thinner than that, and no nearer than that
/// to the tool before, may be missed by the point, and are then handled by keeping out of the part.
struct LayOnPart {
    enum class Along { axis, normal };
    double allowance = 0.0; ///< mm of stock left on the part
    double sampling = 0.1;  ///< mm
    Along along = Along::axis;
};
EditResult apply(const LayOnPart& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// The offset curve of each stroke in plan, at the height of the corresponding point of the stroke: every point of it
/// has its distance from the stroke (within 0.002 mm), and none is nearer to any point of the stroke; loops are
/// removed.
struct Offset {
    SourceInterval interval;
    double distance = 1.0; ///< mm, to the left of the motion; negative: to the right
};
EditResult apply(const Offset& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Rows with a constant step in plan beside a drawn guide, including one along the guide itself, each projected onto
/// the part as by LayOnPart. The strokes of the interval are the guide and are replaced by the rows; a guide of points
/// needs no strokes. Every other row runs backwards.
struct StepOverRows {
    SourceInterval interval;
    std::vector<glm::dvec3> guide;   ///< mm; empty: the strokes of the interval
    double stepOver = 0.5;           ///< mm
    double left = 10.0, right = 0.0; ///< rows beside the guide
    double allowance = 0.0;          ///< mm of stock left on the part
};
/// Errors: argumentInvalid, if the path has no such guide.
EditResult apply(const StepOverRows& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// In the order in which they may follow each other.
using SurfaceEdits = EditKinds<LayOnPart, Offset, StepOverRows, HoldOut, Simplify>;

} // namespace burin
