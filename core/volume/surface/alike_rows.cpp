// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface/alike_rows.h"

#include "core/base/avx512.h"
#include "core/volume/runs/tile.h"

#include <bit>

namespace burin {

#ifdef BURIN_AVX512
BURIN_AVX512_BEGIN

namespace {

static_assert(sizeof(SurfaceLine) == sizeof(std::uint32_t) && sizeof(Segment*) == sizeof(std::uint64_t) &&
              std::endian::native == std::endian::little);

/// Four segments of each line: the one before its first (for the first line of a brick, the memory before its segments)
/// and the following ones. They are within the arena, whatever they contain (BlockArena::overread).
struct Fours {
    __m256i before, first, second, third;
};
/// @param firsts  for fewer than eight lines, the remaining ones repeat those of some line
BURIN_INLINE Fours foursAt(const Segment* segments, __m256i firsts) noexcept {
    static_assert(BlockArena::overread >= 2 * sizeof(Segment));
    alignas(32) std::uint32_t places[8];
    _mm256_store_si256(reinterpret_cast<__m256i*>(places), firsts);
    const auto at = [&](int line) noexcept {
        return _mm_loadu_si128(reinterpret_cast<const __m128i*>(segments + places[line] - 1));
    };
    const auto both = [&](int line) noexcept {
        return _mm256_inserti128_si256(_mm256_castsi128_si256(at(line)), at(line + 4), 1);
    };
    const __m256i a = both(0), b = both(1), c = both(2), d = both(3);
    const __m256i lowAb = _mm256_unpacklo_epi32(a, b), highAb = _mm256_unpackhi_epi32(a, b),
                  lowCd = _mm256_unpacklo_epi32(c, d), highCd = _mm256_unpackhi_epi32(c, d);
    return {_mm256_unpacklo_epi64(lowAb, lowCd), _mm256_unpackhi_epi64(lowAb, lowCd),
            _mm256_unpacklo_epi64(highAb, highCd), _mm256_unpackhi_epi64(highAb, highCd)};
}
/// What scanlines contain within a window, and where they enter and leave it.
struct Seen {
    __m256i lines;                 ///< each a SurfaceLine
    unsigned begins = 0, ends = 0; ///< 1: air, 2: solid, 3: both
};
BURIN_INLINE unsigned bitOf(bool solid) noexcept {
    return SurfaceChanges::bitOf(solid);
}
/// A line without a change.
BURIN_INLINE __m256i uniform(bool solid) noexcept {
    return _mm256_set1_epi32(static_cast<std::uint16_t>(solid ? -SurfaceLine::beyond : SurfaceLine::beyond));
}
/// Positions of the ends of segments, in the lower halves.
BURIN_INLINE __m256i placesOf(const AlikeRows& rows, __m256i segments) noexcept {
    const __m256i position = _mm256_sub_epi32(_mm256_srli_epi32(segments, 8), _mm256_set1_epi32(rows.rounding));
    return _mm256_and_si256(_mm256_sra_epi32(position, _mm_cvtsi32_si128(rows.level)), _mm256_set1_epi32(0xffff));
}
constexpr int toAir = ~0xffff; ///< in the upper half
/// Those that are less, compared as unsigned numbers.
BURIN_INLINE __mmask8 less(__m256i a, __m256i b) noexcept {
    return _mm256_cmplt_epu32_mask(a, b);
}

/// A row, to be read from the segments at which its lines enter the window.
struct Row {
    __mmask8 all; ///< its lines
    __m256i firsts, ends;
    Fours fours;
};

/// False if the row's lines are not alike.
BURIN_INLINE bool readRow(const AlikeRows& rows, const Row& row, bool skips, std::uint8_t* seen, Seen& read) noexcept {
    const __m256i low = _mm256_set1_epi32(static_cast<int>(rows.low)),
                  high = _mm256_set1_epi32(static_cast<int>(rows.high));
    const auto propertyOf = [](__m256i segments) noexcept {
        return static_cast<std::uint8_t>(_mm256_cvtsi256_si32(segments));
    };
    const auto same = [&](__m256i segments) noexcept {
        const __m256i first = _mm256_broadcastd_epi32(_mm256_castsi256_si128(segments));
        return _mm256_mask_test_epi32_mask(row.all, _mm256_xor_si256(segments, first), _mm256_set1_epi32(0xff)) == 0;
    };
    const auto& [before, first, second, third] = row.fours;
    const bool solid = propertyOf(first) != airProperty;
    if ((less(low, first) & row.all) != row.all || (skips && (less(low, before) & row.all) != 0) || !same(first) ||
        (rows.opens && solid))
        return false;
    seen[propertyOf(first)] = 1;
    read = {uniform(solid), bitOf(solid), bitOf(solid)};
    bool changed = false, solidBehind = solid;
    const auto goesOn = [&](__m256i segment) noexcept { return (less(segment, high) & row.all) != 0; };
    const auto goOn = [&](__m256i segment, __m256i next, int behind) noexcept {
        const __m256i place = _mm256_add_epi32(row.firsts, _mm256_set1_epi32(behind));
        if ((less(segment, high) & less(place, row.ends) & row.all) != row.all || !same(next)) return false;
        seen[propertyOf(next)] = 1;
        if ((propertyOf(next) != airProperty) == solidBehind) return true;
        if (changed) return false;
        solidBehind = !solidBehind;
        read.lines = _mm256_or_si256(placesOf(rows, segment), _mm256_set1_epi32(solidBehind ? 0 : toAir));
        read.ends = bitOf(solidBehind);
        return changed = true;
    };
    if (!goesOn(first)) return true;
    if (!goOn(first, second, 1)) return false;
    if (!goesOn(second)) return true;
    return goOn(second, third, 2) && !goesOn(third);
}

std::size_t readRows(const AlikeRows& rows, std::uint32_t skipped, const ReadRows& to,
                     SurfaceChanges& changes) noexcept {
    const auto all = static_cast<__mmask8>((1U << rows.lines) - 1);
    const __m256i skips = _mm256_set1_epi32(static_cast<int>(skipped));
    const __m512i base = _mm512_set1_epi64(reinterpret_cast<std::int64_t>(rows.segments));
    for (std::size_t i = 0; i < rows.rows; ++i) {
        const std::uint32_t* const offsets = rows.offsets + i * tileSide;
        Row row{all,
                _mm256_add_epi32(_mm256_maskz_loadu_epi32(all, offsets), skips),
                _mm256_maskz_loadu_epi32(all, offsets + 1),
                {}};
        if ((less(row.firsts, row.ends) & all) != all) return i;
        const __m256i some = _mm256_broadcastd_epi32(_mm256_castsi256_si128(row.firsts));
        row.fours = foursAt(rows.segments, _mm256_mask_blend_epi32(all, some, row.firsts));
        Seen read;
        if (!readRow(rows, row, skipped > 0, to.seen, read)) return i;
        _mm256_mask_storeu_epi32(to.lines + i * to.step, all, read.lines);
        const __m512i bytes = _mm512_maskz_slli_epi64(all, _mm512_maskz_cvtepu32_epi64(all, row.firsts),
                                                      std::countr_zero(sizeof(Segment)));
        _mm512_mask_storeu_epi64(to.firstSegments + i * to.step, all, _mm512_add_epi64(base, bytes));
        changes.atBegin |= read.begins;
        changes.atEnd |= read.ends;
    }
    return rows.rows;
}

} // namespace

BURIN_AVX512_END
#endif

std::size_t readAlikeRows([[maybe_unused]] const AlikeRows& rows, [[maybe_unused]] std::uint32_t skipped,
                          [[maybe_unused]] const ReadRows& to, [[maybe_unused]] SurfaceChanges& changes) noexcept {
#ifdef BURIN_AVX512
    if (hasAvx512) return readRows(rows, skipped, to, changes);
#endif
    return 0;
}

} // namespace burin
