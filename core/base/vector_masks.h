// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/vectorised.h"

// Conditions lane by lane, for loops that are compiled for processors with AVX-512 as well: those have registers for
// conditions, which no compiler finds from comparisons of vectors, and twice the others. Such a loop stands in a file
// of its own, which is included for each kind of processor with `using namespace` of one of the namespaces below.
namespace burin::vector_masks {

using Mask = Integers; ///< all bits or none

BURIN_INLINE Mask greater(Integers a, Integers b) noexcept {
    return a > b;
}
BURIN_INLINE Mask unlike(Integers a, Integers b) noexcept {
    return a != b;
}
BURIN_INLINE Integers select(Mask mask, Integers then, Integers otherwise) noexcept {
    return mask ? then : otherwise;
}

} // namespace burin::vector_masks

#ifdef BURIN_KNOWS_PROCESSORS
#include <immintrin.h>

#define BURIN_AVX512
#define BURIN_AVX512_BEGIN _Pragma("GCC push_options") _Pragma("GCC target(\"avx2,avx512f,avx512vl,avx512dq\")")
#define BURIN_AVX512_END _Pragma("GCC pop_options")

namespace burin {
inline const bool hasAvx512 =
    __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq");
}

BURIN_AVX512_BEGIN
namespace burin::vector_masks_avx512 {

/// A bit a lane.
struct Mask {
    __mmask8 bits;
    BURIN_INLINE friend Mask operator&(Mask a, Mask b) noexcept { return {_kand_mask8(a.bits, b.bits)}; }
    BURIN_INLINE friend Mask operator|(Mask a, Mask b) noexcept { return {_kor_mask8(a.bits, b.bits)}; }
    BURIN_INLINE friend Mask operator~(Mask a) noexcept { return {_knot_mask8(a.bits)}; }
};

BURIN_INLINE Mask greater(Integers a, Integers b) noexcept {
    return {_mm256_cmpgt_epi32_mask(reinterpret_cast<__m256i>(a), reinterpret_cast<__m256i>(b))};
}
BURIN_INLINE Mask unlike(Integers a, Integers b) noexcept {
    return {_mm256_cmpneq_epi32_mask(reinterpret_cast<__m256i>(a), reinterpret_cast<__m256i>(b))};
}
BURIN_INLINE Integers select(Mask mask, Integers then, Integers otherwise) noexcept {
    return reinterpret_cast<Integers>(
        _mm256_mask_blend_epi32(mask.bits, reinterpret_cast<__m256i>(otherwise), reinterpret_cast<__m256i>(then)));
}
BURIN_INLINE std::uint32_t bitsOf(Mask mask) noexcept {
    return mask.bits;
}

} // namespace burin::vector_masks_avx512
BURIN_AVX512_END
#endif
