// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/tile.h"

// Within core/volume: the inner loop of RunVolume::clear.
namespace burin::kernels {

/// An interval of air within one run splits it into three segments.
inline constexpr std::uint32_t mostAddedByLine = 2;

/// Writes the scanlines of a brick without the material to remove; neighbours of one property are merged.
/// @param machinable  by property: runs of other properties stay
/// @param cleared     has room for `mostAddedByLine` more segments for each line of `spans`
/// @param amounts     the removed material is counted as air there
void writeCleared(const Tile& present, const BrickSpans& spans, const std::array<bool, 256>& machinable,
                  const Tile& cleared, RunAmounts& amounts) noexcept;

} // namespace burin::kernels
