// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_values.h"

namespace burin {

// Edits that make arcs, and those that rely on strokes being ready otherwise.

/// Arcs and helices of constant pitch in the three planes, and lines between them, through points of the stroke: no
/// place of the stroke lies farther than `tolerance` from the result, nor the other way round. An arc is taken where it
/// replaces at least three moves and more of the stroke than a line would, keeps the tool as far from the part as the
/// points had to be, and obeys these rules and the machine's own (MachineProfile::arcs), the stricter of both: at most
/// `largestSweep`, a radius within bounds, and radii that differ by no more than `radiusMismatch` between start and end
/// once all figures are rounded to the control's decimals.
struct FitArcs {
    double tolerance = 0.01;                   ///< mm
    double largestSweep = 3.14159265358979324; ///< rad
    double smallestRadius = 0.1;               ///< mm
    double largestRadius = 1000.0;             ///< mm
    double radiusMismatch = 0.002;             ///< mm
};
EditResult apply(const FitArcs& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Rounds corners between straight moves, so that the path passes each by exactly `tolerance`, or nearer where a leg
/// would need more than half of a move: an arc with R = e / (1 / sin(phi / 2) - 1) where both moves lie in one of the
/// three planes, its centre on the control's figures; else a parabola with legs of 2 e / cos(phi / 2), in chords that
/// leave it by 0.001 mm at most. Corners that turn by less than `smallestTurn`, or by more than 170°, stay; so does one
/// that can't be cut clear of the part.
struct RoundCorners {
    double tolerance = 0.05;    ///< e, mm from the corner
    double smallestTurn = 0.05; ///< rad
};
EditResult apply(const RoundCorners& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// What leads go by. By the recording: the hand's own motion where the stroke begins, which no edit changes, chooses
/// the side, and a first move that is turned far from it by chance does not turn the lead. By the first move: whatever
/// stands before the lead may turn it (earlier version).
enum class LeadDirection { firstMove, recording };

/// A way into strokes, tangent to their first move: level in a line, on a quarter of a circle from the side, down a
/// ramp, or down a helix. Each is tried on both sides and at half its size, twice; where none keeps the tool from the
/// part as the stroke has to be and clear of fixtures, there is none.
struct LeadIn {
    enum class Form { line, arc, ramp, helix };
    SourceStretch stretch;
    Form form = Form::arc;
    double size = 3.0;   ///< mm: length of a line or ramp in plan, radius of an arc or helix
    double height = 1.0; ///< mm, that a ramp or helix goes down
    double angle = 0.05; ///< rad, of a helix: no steeper
    LeadDirection direction = LeadDirection::recording;
};
EditResult apply(const LeadIn& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// A way out of strokes, tangent to their last move, as LeadIn has it.
struct LeadOut {
    enum class Form { line, arc };
    SourceStretch stretch;
    Form form = Form::arc;
    double size = 3.0; ///< mm
    LeadDirection direction = LeadDirection::recording;
};
EditResult apply(const LeadOut& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// In the order in which they may follow each other.
using CurveEdits = EditKinds<RoundCorners, FitArcs, LeadIn, LeadOut>;

} // namespace burin
