// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/arc.h"
#include "core/nc/dialect_data.h"
#include "core/nc/number_words.h"

#include <array>
#include <vector>

namespace burin {

/// A position in steps of a program's last digit.
using StepPlace = std::array<long long, 3>;

/// What is written for an arc or a part of it: a line, or an arc with its centre relative to the start, both in written
/// numbers.
struct StepMove {
    StepPlace to{};
    bool arc = false;
    StepPlace offset{}; ///< of the centre from the start of the move; 0 along the axis
};

/// An arc in the form that a control accepts, starting at the position that was written last. Sweeps longer than the
/// control accepts are split evenly. The end point is rounded first. The centre is moved onto the perpendicular
/// bisector of the written end points and then rounded (to a neighbouring step if that agrees better), so that the
/// radii agree within the dialect's mismatch (checked on the written numbers). This may move the centre of a flat arc
/// far, but not its path. Lines are written instead, within `lineChord` of the arc, where no such centre exists, where
/// the path would deviate or the arc would turn by another angle, and for radii and sweeps that controls do not accept
/// (more than `largestRadius`, less than `smallestRadius` or 0.001 rad). Rounding moves the path of an arc by no more
/// than 0.005 mm with three decimals of a millimetre, 0.008 mm with four of an inch.
/// @param from the current position as it was written, within a step of `arc.from`
std::vector<StepMove> arcSteps(const Arc& arc, const StepPlace& from, const NumberWords& numbers,
                               const DialectArcs& limits);
inline constexpr double lineChord = 0.001; ///< mm

} // namespace burin
