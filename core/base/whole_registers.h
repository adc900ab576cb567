// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/avx512.h"

#include <bit>
#include <cstddef>
#include <cstdint>

// Vectors as wide as the widest registers, for loops that are compiled for both widths: such a loop is in a file of its
// own, which is included once for each width with `using namespace` of one of the namespaces below. Comments on the
// first one apply to the second as well.
namespace burin {

/// Consecutive numbers in memory, as many as a register of that kind holds.
template <class Lanes, class Number>
BURIN_INLINE Lanes lanesAt(const Number* from) noexcept {
    static_assert(sizeof(Lanes) % sizeof(Number) == 0);
    Lanes values;
    __builtin_memcpy(&values, from, sizeof values);
    return values;
}
template <class Lanes, class Number>
BURIN_INLINE void storeAt(const Lanes& values, Number* to) noexcept {
    static_assert(sizeof(Lanes) % sizeof(Number) == 0);
    __builtin_memcpy(to, &values, sizeof values);
}

} // namespace burin

namespace burin::eight_lanes {

using burin::Floats;
using burin::Integers;
using burin::Words;
using Mask = Integers; ///< all bits or none
inline constexpr std::size_t width = 8;

BURIN_INLINE Floats each(float value) noexcept {
    return floats(value);
}
BURIN_INLINE Integers each(std::int32_t value) noexcept {
    return integers(value);
}
/// 0, 1, 2, …
BURIN_INLINE Integers numbers() noexcept {
    return Integers{0, 1, 2, 3, 4, 5, 6, 7};
}
using burin::floatsOf;
using burin::rootsOf;
BURIN_INLINE Mask greater(Integers a, Integers b) noexcept {
    return a > b;
}
BURIN_INLINE Mask greater(Floats a, Floats b) noexcept {
    return a > b;
}
BURIN_INLINE Mask unlike(Integers a, Integers b) noexcept {
    return a != b;
}
BURIN_INLINE Integers select(Mask mask, Integers then, Integers otherwise) noexcept {
    return mask ? then : otherwise;
}
using burin::bitsOf;
using burin::least;
using burin::most;
using burin::wholeOf;
/// The first number in the first eight lanes, the next one in the next eight if a register holds two groups of eight.
BURIN_INLINE Floats eachEight(float first, float) noexcept {
    return floats(first);
}
/// The lanes selected by the lowest bits, one per lane; the bits of a group of eight lanes are equal.
BURIN_INLINE Mask lanesOf(std::uint64_t bits) noexcept {
    return integers(-static_cast<std::int32_t>(bits & 1U));
}
/// The index of the group of eight that a lane belongs to: 0, and 1 if a register holds two.
BURIN_INLINE Floats eightNumbers() noexcept {
    return Floats{};
}
BURIN_INLINE Mask hasSign(Floats numbers) noexcept {
    return reinterpret_cast<Integers>(numbers) >> 31;
}
BURIN_INLINE Floats select(Mask mask, Floats then, Floats otherwise) noexcept {
    return mask ? then : otherwise;
}
/// Adds one where the mask is set.
BURIN_INLINE Integers counted(Integers count, Mask mask) noexcept {
    return count - mask;
}
/// Writes the words selected by the mask consecutively, followed by arbitrary ones, `width` in total.
/// @return behind the last selected word
BURIN_INLINE std::uint32_t* append(Words words, Mask mask, std::uint32_t* to) noexcept {
    for (std::size_t i = 0; i < width; ++i) {
        *to = words[static_cast<int>(i)];
        to -= mask[static_cast<int>(i)];
    }
    return to;
}
/// The first numbers of groups of four, the second ones, …
template <class Lanes>
struct Fours {
    Lanes of[4];
};
/// Reads groups of four numbers and separates them: the first of each group, then the second, …
/// @tparam step distance from group to group
template <class Lanes, int step, class Number>
BURIN_INLINE Fours<Lanes> foursAt(const Number* from) noexcept {
    const auto both = [&](int i) noexcept -> Lanes { // of group i and of group 4 + i
        Number __attribute__((vector_size(16))) low, high;
        __builtin_memcpy(&low, from + step * i, sizeof low);
        __builtin_memcpy(&high, from + step * (4 + i), sizeof high);
        return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
    };
    const Lanes a = both(0), b = both(1), c = both(2), d = both(3);
    const Lanes lowAb = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13),
                lowCd = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13),
                highAb = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15),
                highCd = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
    return {{__builtin_shufflevector(lowAb, lowCd, 0, 1, 8, 9, 4, 5, 12, 13),
             __builtin_shufflevector(lowAb, lowCd, 2, 3, 10, 11, 6, 7, 14, 15),
             __builtin_shufflevector(highAb, highCd, 0, 1, 8, 9, 4, 5, 12, 13),
             __builtin_shufflevector(highAb, highCd, 2, 3, 10, 11, 6, 7, 14, 15)}};
}
/// Writes interleaved vectors, and one number more.
BURIN_INLINE void storeVectors(Floats x, Floats y, Floats z, float* to) noexcept {
    const Floats low = __builtin_shufflevector(x, y, 0, 8, 1, 9, 4, 12, 5, 13),
                 high = __builtin_shufflevector(x, y, 2, 10, 3, 11, 6, 14, 7, 15);
    const Floats vectors[4]{// i, and in the upper half 4 + i
                            __builtin_shufflevector(low, z, 0, 1, 8, 8, 4, 5, 12, 12),
                            __builtin_shufflevector(low, z, 2, 3, 9, 9, 6, 7, 13, 13),
                            __builtin_shufflevector(high, z, 0, 1, 10, 10, 4, 5, 14, 14),
                            __builtin_shufflevector(high, z, 2, 3, 11, 11, 6, 7, 15, 15)};
    for (int i = 0; i < 4; ++i) {
        const auto four = __builtin_shufflevector(vectors[i], vectors[i], 0, 1, 2, 3);
        __builtin_memcpy(to + 3 * i, &four, sizeof four);
    }
    for (int i = 0; i < 4; ++i) {
        const auto four = __builtin_shufflevector(vectors[i], vectors[i], 4, 5, 6, 7);
        __builtin_memcpy(to + 3 * (4 + i), &four, sizeof four);
    }
}

} // namespace burin::eight_lanes

#ifdef BURIN_AVX512
BURIN_AVX512_BEGIN
namespace burin::sixteen_lanes {

using Floats = float __attribute__((vector_size(64)));
using Integers = std::int32_t __attribute__((vector_size(64)));
using Words = std::uint32_t __attribute__((vector_size(64)));
struct Mask {
    __mmask16 bits;
    BURIN_INLINE friend Mask operator&(Mask a, Mask b) noexcept { return {_kand_mask16(a.bits, b.bits)}; }
    BURIN_INLINE friend Mask operator|(Mask a, Mask b) noexcept { return {_kor_mask16(a.bits, b.bits)}; }
    BURIN_INLINE friend Mask operator^(Mask a, Mask b) noexcept { return {_kxor_mask16(a.bits, b.bits)}; }
    BURIN_INLINE friend Mask operator~(Mask a) noexcept { return {_knot_mask16(a.bits)}; }
};
inline constexpr std::size_t width = 16;

BURIN_INLINE Floats each(float value) noexcept {
    return reinterpret_cast<Floats>(_mm512_set1_ps(value));
}
BURIN_INLINE Integers each(std::int32_t value) noexcept {
    return reinterpret_cast<Integers>(_mm512_set1_epi32(value));
}
BURIN_INLINE Integers numbers() noexcept {
    return Integers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
}
BURIN_INLINE Floats floatsOf(Integers numbers) noexcept {
    return __builtin_convertvector(numbers, Floats);
}
BURIN_INLINE Floats rootsOf(Floats squares) noexcept {
    const Floats held = squares > 0.0F ? squares : Floats{};
    constexpr __mmask16 all = 0xffff; // without a mask g++ 12 warns of its own header (bug 105593)
    return reinterpret_cast<Floats>(_mm512_maskz_sqrt_ps(all, reinterpret_cast<__m512>(held)));
}
BURIN_INLINE Mask greater(Integers a, Integers b) noexcept {
    return {_mm512_cmpgt_epi32_mask(reinterpret_cast<__m512i>(a), reinterpret_cast<__m512i>(b))};
}
BURIN_INLINE Mask unlike(Integers a, Integers b) noexcept {
    return {_mm512_cmpneq_epi32_mask(reinterpret_cast<__m512i>(a), reinterpret_cast<__m512i>(b))};
}
BURIN_INLINE std::uint32_t bitsOf(Mask mask) noexcept {
    return mask.bits;
}
BURIN_INLINE Integers least(Integers a, Integers b) noexcept {
    constexpr __mmask16 all = 0xffff; // as in rootsOf
    return reinterpret_cast<Integers>(
        _mm512_maskz_min_epi32(all, reinterpret_cast<__m512i>(a), reinterpret_cast<__m512i>(b)));
}
BURIN_INLINE Integers most(Integers a, Integers b) noexcept {
    constexpr __mmask16 all = 0xffff; // as in rootsOf
    return reinterpret_cast<Integers>(
        _mm512_maskz_max_epi32(all, reinterpret_cast<__m512i>(a), reinterpret_cast<__m512i>(b)));
}
BURIN_INLINE Floats least(Floats a, Floats b) noexcept {
    return a < b ? a : b;
}
BURIN_INLINE Floats most(Floats a, Floats b) noexcept {
    return a > b ? a : b;
}
BURIN_INLINE Integers wholeOf(Floats numbers) noexcept {
    return __builtin_convertvector(numbers, Integers);
}
BURIN_INLINE Floats eachEight(float first, float next) noexcept {
    constexpr __mmask16 upper = 0xff00;
    return reinterpret_cast<Floats>(_mm512_mask_broadcastss_ps(_mm512_set1_ps(first), upper, _mm_set_ss(next)));
}
BURIN_INLINE Mask lanesOf(std::uint64_t bits) noexcept {
    return {static_cast<__mmask16>(bits)};
}
BURIN_INLINE Floats eightNumbers() noexcept {
    return Floats{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
}
BURIN_INLINE Integers select(Mask mask, Integers then, Integers otherwise) noexcept {
    return reinterpret_cast<Integers>(
        _mm512_mask_blend_epi32(mask.bits, reinterpret_cast<__m512i>(otherwise), reinterpret_cast<__m512i>(then)));
}
BURIN_INLINE Mask greater(Floats a, Floats b) noexcept {
    return {_mm512_cmp_ps_mask(reinterpret_cast<__m512>(a), reinterpret_cast<__m512>(b), _CMP_GT_OQ)};
}
BURIN_INLINE Mask hasSign(Floats numbers) noexcept {
    return {_mm512_movepi32_mask(reinterpret_cast<__m512i>(numbers))};
}
BURIN_INLINE Floats select(Mask mask, Floats then, Floats otherwise) noexcept {
    return reinterpret_cast<Floats>(
        _mm512_mask_blend_ps(mask.bits, reinterpret_cast<__m512>(otherwise), reinterpret_cast<__m512>(then)));
}
BURIN_INLINE Integers counted(Integers count, Mask mask) noexcept {
    const auto before = reinterpret_cast<__m512i>(count);
    return reinterpret_cast<Integers>(_mm512_mask_add_epi32(before, mask.bits, before, _mm512_set1_epi32(1)));
}
BURIN_INLINE std::uint32_t* append(Words words, Mask mask, std::uint32_t* to) noexcept {
    // In a register: compressing directly into memory is many times slower on some processors.
    const __m512i chosen = _mm512_maskz_compress_epi32(mask.bits, reinterpret_cast<__m512i>(words));
    _mm512_storeu_si512(to, chosen);
    return to + std::popcount(mask.bits);
}
using eight_lanes::Fours;
template <class Lanes, int step>
BURIN_INLINE Fours<Lanes> foursAt(const std::uint32_t* from) noexcept {
    const auto four = [&](int i) noexcept { // of groups i, 4 + i, 8 + i, 12 + i
        const auto at = [&](int place) noexcept {
            return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from + step * place));
        };
        const __m512i two = _mm512_inserti32x4(_mm512_castsi128_si512(at(i)), at(4 + i), 1);
        return reinterpret_cast<Words>(_mm512_inserti32x4(_mm512_inserti32x4(two, at(8 + i), 2), at(12 + i), 3));
    };
    const auto low = [](Words a, Words b) noexcept {
        return __builtin_shufflevector(a, b, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29);
    };
    const auto high = [](Words a, Words b) noexcept {
        return __builtin_shufflevector(a, b, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31);
    };
    const Words a = four(0), b = four(1), c = four(2), d = four(3);
    const Words lowAc = low(a, c), lowBd = low(b, d), highAc = high(a, c), highBd = high(b, d);
    return {{low(lowAc, lowBd), high(lowAc, lowBd), low(highAc, highBd), high(highAc, highBd)}};
}
BURIN_INLINE void storeVectors(Floats x, Floats y, Floats z, float* to) noexcept {
    // A third of the numbers in each register: x and y at their positions, then z between them.
    const Floats xy[3]{__builtin_shufflevector(x, y, 0, 16, 0, 1, 17, 0, 2, 18, 0, 3, 19, 0, 4, 20, 0, 5),
                       __builtin_shufflevector(x, y, 21, 0, 6, 22, 0, 7, 23, 0, 8, 24, 0, 9, 25, 0, 10, 26),
                       __builtin_shufflevector(x, y, 0, 11, 27, 0, 12, 28, 0, 13, 29, 0, 14, 30, 0, 15, 31, 0)};
    const auto first = __builtin_shufflevector(xy[0], z, 0, 1, 16, 3, 4, 17, 6, 7, 18, 9, 10, 19, 12, 13, 20, 15),
               second = __builtin_shufflevector(xy[1], z, 0, 21, 2, 3, 22, 5, 6, 23, 8, 9, 24, 11, 12, 25, 14, 15),
               third = __builtin_shufflevector(xy[2], z, 26, 1, 2, 27, 4, 5, 28, 7, 8, 29, 10, 11, 30, 13, 14, 31);
    __builtin_memcpy(to, &first, sizeof first);
    __builtin_memcpy(to + width, &second, sizeof second);
    __builtin_memcpy(to + 2 * width, &third, sizeof third);
}

} // namespace burin::sixteen_lanes
BURIN_AVX512_END

/// In a namespace within burin: selects the names for sixteen lanes over those for eight that burin itself has.
#define BURIN_USING_SIXTEEN_LANES                                                                                      \
    using namespace sixteen_lanes;                                                                                     \
    using sixteen_lanes::bitsOf;                                                                                       \
    using sixteen_lanes::Floats;                                                                                       \
    using sixteen_lanes::floatsOf;                                                                                     \
    using sixteen_lanes::Integers;                                                                                     \
    using sixteen_lanes::least;                                                                                        \
    using sixteen_lanes::most;                                                                                         \
    using sixteen_lanes::rootsOf;                                                                                      \
    using sixteen_lanes::wholeOf;                                                                                      \
    using sixteen_lanes::Words;
#endif
