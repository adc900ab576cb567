// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace burin {

// Edits that make arcs, and those that rely on strokes being ready otherwise.

/// Arcs and helices of constant pitch in the three planes, and lines between them, through points of the stroke: no
/// place of the stroke lies farther than `tolerance` from the result, nor the other way round. An arc is taken where it
/// replaces at least three moves and more of the stroke than a line would, keeps the tool as far from the part as the
/// points had to be, and obeys the control's rules: at most `largestSweep`, a radius within bounds, and radii that
/// differ by no more than `radiusMismatch` between start and end once all figures are rounded to the control's
/// decimals.
struct FitArcs {
    double tolerance = 0.01;                   ///< mm
    double largestSweep = 3.14159265358979324; ///< rad
    double smallestRadius = 0.1;               ///< mm
    double largestRadius = 1000.0;             ///< mm
    double radiusMismatch = 0.002;             ///< mm
};

} // namespace burin
