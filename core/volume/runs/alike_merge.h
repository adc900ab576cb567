// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/avx512.h"
#include "core/volume/runs/tile.h"

#ifdef BURIN_AVX512

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

BURIN_AVX512_BEGIN

namespace burin {

/// Joins the segments of two bricks as BrickMerge does, for bricks whose neighbouring lines are alike: their segments
/// have the same properties, and the ends of both operands alternate in the same order. This holds for more than 19 of
/// 20 lines, and a brick has few such kinds of lines. How a line of one kind is joined is worked out once (`Pattern`);
/// each further line of that kind takes as many vector operations as BrickMerge takes steps. Needs AVX-512
/// (`hasAvx512`).
///
/// @tparam Operation  see BrickMerge
template <class Operation>
class AlikeMerge {
public:
    static constexpr std::uint32_t mostEnds = 16; ///< segments of both lines together
    static constexpr std::size_t spare = mostEnds;

    /// @param segments  has room for the segments of a and b together and for `spare` more
    /// @return false if lines have too many ends or too few lines are alike; what was written is then invalid
    bool run(const Segment* a, const Segment* b, const Tile& linesOfA, const Tile& linesOfB, Segment* segments,
             std::uint32_t* offsets) noexcept {
        Lines lines{a, b, {}, {}, segments, offsets};
        linesOfA.readOffsets(lines.offsetsA);
        linesOfB.readOffsets(lines.offsetsB);
        offsets[0] = 0;
        std::size_t line = 0;
        for (int misses = 0; misses <= mostMisses; ++misses) {
            for (int failures = 0; failures < 2;) {
                const std::size_t next = follow(patterns_[present_], lines, line);
                if (next == linesPerTile) return true;
                failures = next == line ? failures + 1 : 1;
                line = next;
                present_ ^= 1;
            }
            if (lines.endsOf(line) > mostEnds) return false;
            present_ ^= 1; // the pattern that was used less recently
            learn(patterns_[present_], lines, line);
        }
        return false;
    }

private:
    static constexpr std::uint32_t properties = 0xff;
    static constexpr int mostMisses = 16; ///< of 64 lines: a miss takes several times as long as another line

    struct Lines {
        const Segment *a, *b;
        TileOffsets offsetsA, offsetsB;
        Segment* result;
        std::uint32_t* offsets;

        std::uint32_t countA(std::size_t line) const noexcept { return offsetsA[line + 1] - offsetsA[line]; }
        std::uint32_t countB(std::size_t line) const noexcept { return offsetsB[line + 1] - offsetsB[line]; }
        std::uint32_t endsOf(std::size_t line) const noexcept { return countA(line) + countB(line); }
    };

    /// How lines of one kind are joined. Indices count the segments of a from 0 and those of b from 16.
    struct Pattern {
        std::uint32_t countA = 0, countB = 0, count = 0; ///< segments in a line of a, of b and of the result
        __m512i exampleA, exampleB;                      ///< a line of this kind; only its properties are compared
        __m512i order, orderNext;                        ///< indices in order of rising ends, and the successor of each
        __mmask16 rises;                                 ///< set where the next end is greater, not equal
        __m512i chosen, chosenProperties;                ///< of the result: indices of its ends, and its properties
    };

    static __mmask16 first(std::uint32_t count) noexcept { return static_cast<__mmask16>((1U << count) - 1); }
    static __m512i loadAll(const std::array<std::uint32_t, mostEnds>& from) noexcept {
        return _mm512_loadu_si512(from.data());
    }

    /// Joins lines as long as they are of this kind.
    /// @param pattern  a copy, because the compiler must assume that the output may alias it
    /// @return the first line that is not of this kind
    static std::size_t follow(const Pattern pattern, const Lines& lines, std::size_t line) noexcept {
        const __mmask16 ofA = first(pattern.countA), ofB = first(pattern.countB);
        const __m512i property = _mm512_set1_epi32(properties), position = _mm512_set1_epi32(~int{properties});
        std::uint32_t place = lines.offsets[line];
        for (; line < linesPerTile && lines.countA(line) == pattern.countA && lines.countB(line) == pattern.countB;
             ++line) {
            const __m512i a = _mm512_maskz_loadu_epi32(ofA, lines.a + lines.offsetsA[line]),
                          b = _mm512_maskz_loadu_epi32(ofB, lines.b + lines.offsetsB[line]);
            const __m512i endA = _mm512_or_si512(a, property), endB = _mm512_or_si512(b, property);
            const __m512i unlike =
                _mm512_or_si512(_mm512_xor_si512(a, pattern.exampleA), _mm512_xor_si512(b, pattern.exampleB));
            const __m512i end = _mm512_permutex2var_epi32(endA, pattern.order, endB),
                          next = _mm512_permutex2var_epi32(endA, pattern.orderNext, endB);
            if (_mm512_test_epi32_mask(unlike, property) != 0 || _mm512_cmplt_epu32_mask(end, next) != pattern.rises ||
                _mm512_cmpneq_epu32_mask(end, next) != pattern.rises)
                break;
            const __m512i chosen = _mm512_permutex2var_epi32(a, pattern.chosen, b);
            _mm512_storeu_si512(lines.result + place,
                                _mm512_or_si512(_mm512_and_si512(chosen, position), pattern.chosenProperties));
            place += pattern.count;
            lines.offsets[line + 1] = place;
        }
        return line;
    }

    /// Sets the pattern to that of the given line.
    static void learn(Pattern& pattern, const Lines& lines, std::size_t line) noexcept {
        const Segment *const a = lines.a + lines.offsetsA[line], *const b = lines.b + lines.offsetsB[line];
        pattern.countA = lines.countA(line);
        pattern.countB = lines.countB(line);
        pattern.exampleA = _mm512_maskz_loadu_epi32(first(pattern.countA), a);
        pattern.exampleB = _mm512_maskz_loadu_epi32(first(pattern.countB), b);
        std::array<std::uint32_t, mostEnds + 2> order;
        std::array<std::uint32_t, mostEnds> chosen{}, chosenProperties{};
        std::uint32_t placeA = 0, placeB = 0, count = 0, ends = 0, before = 0;
        while (placeA < pattern.countA) { // both lines reach the same end
            const auto inA = std::bit_cast<std::uint32_t>(a[placeA]), inB = std::bit_cast<std::uint32_t>(b[placeB]);
            const std::uint32_t endA = inA | properties, endB = inB | properties;
            const std::uint32_t property = Operation::pick(inA, inB) & properties;
            count += count == 0 || property != before ? 1 : 0; // otherwise the segment is continued
            chosen[count - 1] = endA <= endB ? placeA : mostEnds + placeB;
            chosenProperties[count - 1] = before = property;
            order[ends] = placeA;
            ends += endA <= endB ? 1 : 0;
            order[ends] = mostEnds + placeB;
            ends += endB <= endA ? 1 : 0;
            placeA += endA <= endB ? 1 : 0;
            placeB += endB <= endA ? 1 : 0;
        }
        std::fill(order.begin() + ends, order.end(), order[ends - 1]);
        pattern.count = count;
        pattern.order = _mm512_loadu_si512(order.data());
        pattern.orderNext = _mm512_loadu_si512(order.data() + 1);
        pattern.chosen = loadAll(chosen);
        pattern.chosenProperties = loadAll(chosenProperties);
        const __m512i property = _mm512_set1_epi32(properties);
        const __m512i endA = _mm512_or_si512(pattern.exampleA, property),
                      endB = _mm512_or_si512(pattern.exampleB, property);
        pattern.rises = _mm512_cmplt_epu32_mask(_mm512_permutex2var_epi32(endA, pattern.order, endB),
                                                _mm512_permutex2var_epi32(endA, pattern.orderNext, endB));
    }

    std::array<Pattern, 2> patterns_{}; ///< the two patterns that were used last
    std::size_t present_ = 0;
};

} // namespace burin

BURIN_AVX512_END

#endif
