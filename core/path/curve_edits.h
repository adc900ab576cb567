// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_values.h"

namespace burin {

// Edits that make arcs, and edits that need strokes which are otherwise finished.

/// Replaces points of the stroke by arcs and helices of constant pitch in the three planes, and lines between them: no
/// point of the stroke lies farther than `tolerance` from the result, nor the other way round. An arc is used where it
/// replaces at least three moves and more of the stroke than a line would, and keeps the tool as far from the part as
/// the points had to be. It obeys these rules and those of the machine (MachineProfile::arcs), the stricter of both: a
/// sweep of at most `largestSweep`, a radius within bounds, and radii that differ by no more than `radiusMismatch`
/// between start and end once all values are rounded to the control's decimals.
struct FitArcs {
    double tolerance = 0.01;                   ///< mm
    double largestSweep = 3.14159265358979324; ///< rad
    double smallestRadius = 0.1;               ///< mm
    double largestRadius = 1000.0;             ///< mm
    double radiusMismatch = 0.002;             ///< mm
};
EditResult apply(const FitArcs& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Rounds corners between straight moves, so that the path passes each at exactly `tolerance`, or nearer where a leg
/// would need more than half of a move. Where both moves lie in one of the three planes: an arc with R = e / (1 /
/// sin(phi / 2) - 1), its centre on the control's number grid; else a parabola with legs of 2 e / cos(phi / 2), in
/// chords that leave it by 0.001 mm at most. Corners that turn by less than `smallestTurn`, or by more than 170°, stay,
/// as do those that cannot be rounded clear of the part.
struct RoundCorners {
    double tolerance = 0.05;    ///< e, mm from the corner
    double smallestTurn = 0.05; ///< rad
};
EditResult apply(const RoundCorners& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// What determines the direction of a lead. By the recording: the hand's own motion where the stroke begins, which no
/// edit changes, decides the side, and a first move that happens to point far away from it does not turn the lead. By
/// the first move: any edit before the lead may turn it (earlier version).
enum class LeadDirection { firstMove, recording };

/// Adds a lead-in to strokes, tangent to their first move: a level line, a quarter of a circle from the side, a ramp
/// down, or a helix down. Each is tried on both sides and at half and a quarter of its size. There is none where no
/// form keeps the tool as far from the part as the stroke has to be and clear of fixtures.
struct LeadIn {
    enum class Form { line, arc, ramp, helix };
    SourceInterval interval;
    Form form = Form::arc;
    double size = 3.0;   ///< mm: length of a line or ramp in plan, radius of an arc or helix
    double height = 1.0; ///< mm, by which a ramp or helix descends
    double angle = 0.05; ///< rad, steepest descent of a helix
    LeadDirection direction = LeadDirection::recording;
};
EditResult apply(const LeadIn& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// Adds a lead-out to strokes, tangent to their last move; rules as for LeadIn.
struct LeadOut {
    enum class Form { line, arc };
    SourceInterval interval;
    Form form = Form::arc;
    double size = 3.0; ///< mm
    LeadDirection direction = LeadDirection::recording;
};
EditResult apply(const LeadOut& edit, PathUnderEdit& state, const PathContext& context, Progress& progress);

/// In the order in which they may follow each other.
using CurveEdits = EditKinds<RoundCorners, FitArcs, LeadIn, LeadOut>;

} // namespace burin
