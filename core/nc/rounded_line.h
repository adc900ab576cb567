// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/number_words.h"
#include "core/nc/program.h"

#include <vector>

namespace burin {

/// The moves of a section without the back-steps (`isBackStep`) that result from rounding short straight feed moves:
/// with three decimals, (3, 0), (3.0006, -0.0006), (3.0004, 0.0004) becomes a move forth and back. Points within two
/// steps of the last digit of the line without them are left out. Where that is not enough, a point is written at
/// another position, within two steps of its own. Moves on which a rotary axis turns stay as they are. Both ends of a
/// series of straight feed moves stay, among them ends of arcs. The comment of a move that is left out goes to the next
/// one.
std::vector<NcMove> withoutRoundedBackSteps(const std::vector<NcMove>& moves, const NumberWords& numbers);

} // namespace burin
