// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_values.h"

namespace burin {

// Edits that know the part, and those that thin what they leave, in any order.

/// Pushes every place of the path out of the part, grown by the take's allowance plus `clearance`: closest point on the
/// fine mesh at the points and every `sampling` between them, closer where a corner may be cut. Points that carry no
/// shape (0.002 mm) are dropped first. Afterwards every place of every move within a stroke keeps at least the
/// allowance. What is not pushed out within a few steps is lifted along the tool axis.
struct HoldOut {
    double clearance = 0.005; ///< mm
    double sampling = 0.1;    ///< mm
};
EditResult apply(const HoldOut& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Fewest points such that no dropped one is farther than `tolerance` from the result (Douglas & Peucker, distance to
/// segments). Never lets a segment enter the part: a shortcut that would is not taken.
struct Simplify {
    double tolerance = 0.01; ///< mm
};
EditResult apply(const Simplify& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Lays strokes on the part, grown by `allowance`: the tool comes down along its axis from above the part, or goes
/// along the way that the distance changes fastest, until it touches; exact on the mesh, at points `sampling` apart at
/// most. Then the stroke is held out with that allowance as HoldOut does it, moves between the points included. Where
/// nothing lies below, down to the stock's floor, or the way leads nowhere, the stroke ends; it goes on behind. Steps
/// on the way down are 0.02 mm at least: what is thinner than that, and no nearer than that to the tool before, may be
/// passed by the point, and is then met by the hold-out.
struct LayOnPart {
    enum class Along { axis, normal };
    double allowance = 0.0; ///< mm of stock left on the part
    double sampling = 0.1;  ///< mm
    Along along = Along::axis;
};
EditResult apply(const LayOnPart& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// The curve beside each stroke, in plan, at the same height as the place beside it: every place of it has its distance
/// from the stroke (within 0.002 mm), and none is nearer to any of its places; loops go.
struct Offset {
    SourceStretch stretch;
    double distance = 1.0; ///< mm, to the left of the motion; negative: to the right
};
EditResult apply(const Offset& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Rows with the same step in plan beside a guide that was drawn, the guide's own among them, each laid on the part as
/// LayOnPart does it. The strokes of the stretch are the guide and give way to the rows; a guide of places needs none.
/// Every other row goes back.
struct StepOverRows {
    SourceStretch stretch;
    std::vector<glm::dvec3> guide;   ///< mm; none: the strokes of the stretch
    double stepOver = 0.5;           ///< mm
    double left = 10.0, right = 0.0; ///< rows beside the guide
    double allowance = 0.0;          ///< mm of stock left on the part
};
/// Errors: argumentInvalid, where the path has no such guide.
EditResult apply(const StepOverRows& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// In the order in which they may follow each other.
using SurfaceEdits = EditKinds<LayOnPart, Offset, StepOverRows, HoldOut, Simplify>;

} // namespace burin
