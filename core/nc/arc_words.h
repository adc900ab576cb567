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

/// Reads an arc that ends at `target` (X, Y, Z, mm): centre by I J K (from the start, or of the program's frame) or
/// radius by R. A radius that misses the half chord by no more than the control's radius rule gives half a circle.
/// Centre and radius are checked by that rule; nothing is put right. `known` are the axes known at its end.
/// @return false and `fault` filled
bool readArc(const Block& block, const ModalState& state, const Control& control, const glm::dvec3& target,
             AxisSet known, ArcWords& words, BlockFault& fault);

} // namespace burin
