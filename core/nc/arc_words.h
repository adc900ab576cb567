// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/modal_state.h"

namespace burin {

/// An arc as a block describes it.
struct ArcWords {
    Arc arc;
    std::uint32_t wholeTurns = 0; ///< before the last one
};

/// Reads an arc that ends at `target` (X, Y, Z, mm), with its centre by I J K (relative to the start, or in the
/// program's frame) or its radius by R. A radius that is less than half the chord by no more than the control's radius
/// rule allows gives half a circle. Centre and radius are checked by that rule and not corrected. `known` are the axes
/// known at the end of the arc.
/// @return false, with `fault` filled, if the arc is not valid
bool readArc(const Block& block, const ModalState& state, const Control& control, const glm::dvec3& target,
             AxisSet known, ArcWords& words, BlockFault& fault);

} // namespace burin
