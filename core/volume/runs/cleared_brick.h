// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/tile.h"

// Within core/volume: the inner loop of RunVolume::clear.
namespace burin::kernels {

/// A stretch of air within one run makes three segments of one.
inline constexpr std::uint32_t mostAddedByLine = 2;

/// Writes the scanlines of a brick without what is to be removed from them; neighbours of one property become one.
/// @param machinable by property: others stay
/// @param cleared    has room for `mostAddedByLine` segments more for each line of `spans`
/// @param amounts    what is removed turns to air there
void writeCleared(const Tile& present, const BrickSpans& spans, const std::array<bool, 256>& machinable,
                  const Tile& cleared, RunAmounts& amounts) noexcept;

} // namespace burin::kernels
