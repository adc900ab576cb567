// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cut_cache.h"

// Internal to core/cutting: the inner loop of CutCache.
namespace burin::kernels {

/// The progress of `growGaps`, and the lines that it leaves to its caller.
struct Growth {
    CutCache::Open* open = nullptr; ///< room for all rows of all bricks
    std::size_t openCount = 0;
    std::int32_t brick = 0; ///< along u, the next one to process
};
/// Grows the gaps whose spans extend beyond them while the neighbouring segments are long enough; sums up what is
/// removed.
/// Returns false if the next brick is not ready for cuts.
bool growGaps(const CutCache::BrickRow& row, CutCache::Sums& sums, Growth& growth) noexcept;

/// The same for processors without AVX-512; bit-identical, which a test checks.
namespace any_processor {
bool grow(const CutCache::BrickRow& row, CutCache::Sums& sums, Growth& growth) noexcept;
}

} // namespace burin::kernels
