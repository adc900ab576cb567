// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/arc.h"
#include "core/nc/dialect_data.h"
#include "core/nc/number_words.h"

#include <array>
#include <vector>

namespace burin {

/// A place in steps of a program's last digit.
using StepPlace = std::array<long long, 3>;

/// What an arc becomes in a program: a line, or an arc with its centre from the start, both as they are written.
struct StepMove {
    StepPlace to{};
    bool arc = false;
    StepPlace offset{}; ///< of the centre from where the move begins; 0 along the axis
};

/// An arc as a control takes it, from the place that was written last. Longer sweeps than it takes are split evenly.
/// The end point is rounded first; the centre is moved onto the perpendicular of the middle between both ends as they
/// are written, and then rounded (to a neighbour where that agrees better), so that the radii agree within the
/// dialect's mismatch (checked on the written numbers). A flat arc's centre goes far by that, its way does not. Where
/// that can't be had, the way would stray, or the arc turn by another angle, and for radii and sweeps beyond what
/// controls take (more than `largestRadius`, less than `smallestRadius` or 0.001 rad), lines stand in, which leave the
/// arc by no more than `lineChord`. Rounding moves the path of an arc off the true one by no more than 0.005 mm with
/// three decimals of a millimetre, 0.008 mm with four of an inch.
/// @param from where the program stands as it was written, within a step of `arc.from`
std::vector<StepMove> arcSteps(const Arc& arc, const StepPlace& from, const NumberWords& numbers,
                               const DialectArcs& limits);
inline constexpr double lineChord = 0.001; ///< mm

} // namespace burin
