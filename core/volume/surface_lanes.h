// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <emmintrin.h>

namespace burin {

// Columns of nodes of 16 bits, eight at a time with what every x86-64 processor has (SSE2). Columns are multiples of
// eight long and need not be aligned.

inline constexpr std::size_t nodeLanes = 8;

inline __m128i eightNodes(const void* at) noexcept {
    return _mm_loadu_si128(static_cast<const __m128i*>(at));
}
inline void storeEightNodes(void* at, __m128i values) noexcept {
    _mm_storeu_si128(static_cast<__m128i*>(at), values);
}

/// result = before + 2 at + behind.
inline void averageColumns(const std::uint16_t* before, const std::uint16_t* at, const std::uint16_t* behind,
                           std::size_t count, std::uint16_t* result) noexcept {
    for (std::size_t n = 0; n < count; n += nodeLanes) {
        const __m128i middle = eightNodes(at + n);
        const __m128i sum = _mm_add_epi16(eightNodes(before + n), eightNodes(behind + n));
        storeEightNodes(result + n, _mm_add_epi16(sum, _mm_add_epi16(middle, middle)));
    }
}

/// Adds what each node sees of low … high: node n sees from 256 n - 128 to 256 n + 384.
inline void addSeen(std::int16_t low, std::int16_t high, std::size_t count, std::int16_t* sums) noexcept {
    __m128i sees = _mm_set_epi16(1664, 1408, 1152, 896, 640, 384, 128, -128);
    const __m128i lows = _mm_set1_epi16(low), highs = _mm_set1_epi16(high), whole = _mm_set1_epi16(512);
    for (std::size_t n = 0; n < count; n += nodeLanes) {
        const __m128i end = _mm_min_epi16(highs, _mm_add_epi16(sees, whole));
        const __m128i solid = _mm_sub_epi16(end, _mm_max_epi16(lows, sees));
        const __m128i seen = _mm_max_epi16(solid, _mm_setzero_si128());
        storeEightNodes(sums + n, _mm_add_epi16(eightNodes(sums + n), seen));
        sees = _mm_add_epi16(sees, _mm_set1_epi16(2048));
    }
}

/// Which of eight nodes are at least `half`: a bit each.
inline std::uint32_t insideBits(const std::uint16_t* values, std::uint16_t half) noexcept {
    const __m128i below = _mm_subs_epu16(_mm_set1_epi16(static_cast<short>(half)), eightNodes(values));
    const __m128i inside = _mm_cmpeq_epi16(below, _mm_setzero_si128());
    return static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_packs_epi16(inside, _mm_setzero_si128())));
}

} // namespace burin
