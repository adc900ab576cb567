// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/cut_cache_kernels.h"

#include "core/base/whole_registers.h"

#include <bit>

namespace burin::kernels {

namespace any_processor {
using namespace eight_lanes;
#include "core/cutting/cut_cache_lanes.h"

BURIN_VECTORISED bool grow(const CutCache::BrickRow& row, CutCache::Sums& sums, Growth& growth) noexcept {
    return growAll(row, sums, growth);
}
} // namespace any_processor

#ifdef BURIN_AVX512
BURIN_AVX512_BEGIN
namespace avx512 {
BURIN_USING_SIXTEEN_LANES
#include "core/cutting/cut_cache_lanes.h"

bool grow(const CutCache::BrickRow& row, CutCache::Sums& sums, Growth& growth) noexcept {
    return growAll(row, sums, growth);
}
} // namespace avx512
BURIN_AVX512_END
#endif

bool growGaps(const CutCache::BrickRow& row, CutCache::Sums& sums, Growth& growth) noexcept {
#ifdef BURIN_AVX512
    if (hasAvx512) return avx512::grow(row, sums, growth);
#endif
    return any_processor::grow(row, sums, growth);
}

} // namespace burin::kernels
