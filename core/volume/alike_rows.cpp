// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/alike_rows.h"

#include "core/base/vector_masks.h"

#include <bit>

namespace burin {

#ifdef BURIN_AVX512
BURIN_AVX512_BEGIN

namespace {

static_assert(sizeof(SurfaceLine) == sizeof(std::uint32_t) && sizeof(Segment*) == sizeof(std::uint64_t) &&
              std::endian::native == std::endian::little);

/// One segment of each line.
BURIN_INLINE __m256i gather(const AlikeRow& row, __mmask8 lines, __m256i places) noexcept {
    return _mm256_mmask_i32gather_epi32(_mm256_setzero_si256(), lines, places, row.segments, sizeof(Segment));
}
BURIN_INLINE std::uint8_t propertyOfFirst(__m256i segments) noexcept {
    return static_cast<std::uint8_t>(_mm256_cvtsi256_si32(segments));
}
/// Lines whose segment has another property than the first line's.
BURIN_INLINE __mmask8 unlikeFirst(__m256i segments, __mmask8 lines) noexcept {
    const __m256i first = _mm256_broadcastd_epi32(_mm256_castsi256_si128(segments));
    return _mm256_mask_test_epi32_mask(lines, _mm256_xor_si256(segments, first), _mm256_set1_epi32(0xff));
}

/// What is written for lines that change at the ends of these segments.
BURIN_INLINE __m256i changesAt(const AlikeRow& row, __m256i segments, bool toAir) noexcept {
    const __m256i position = _mm256_sub_epi32(_mm256_srli_epi32(segments, 8), _mm256_set1_epi32(row.rounding));
    const __m256i place = _mm256_sra_epi32(position, _mm_cvtsi32_si128(row.level));
    return _mm256_or_si256(_mm256_and_si256(place, _mm256_set1_epi32(0xffff)), _mm256_set1_epi32(toAir ? ~0xffff : 0));
}
BURIN_INLINE __m256i uniform(bool solid) noexcept {
    return _mm256_set1_epi32(static_cast<std::uint16_t>(solid ? -SurfaceLine::beyond : SurfaceLine::beyond));
}

std::optional<AlikeEnds> readRow(const AlikeRow& row, SurfaceLine* lines, const Segment** firstSegments,
                                 std::uint8_t* seen) noexcept {
    const auto all = static_cast<__mmask8>((1U << row.count) - 1);
    const __m256i end = _mm256_maskz_loadu_epi32(all, row.offsets + 1), one = _mm256_set1_epi32(1);
    const __m256i low = _mm256_set1_epi32(static_cast<int>(row.low)),
                  high = _mm256_set1_epi32(static_cast<int>(row.high));
    const __m256i first =
        _mm256_add_epi32(_mm256_maskz_loadu_epi32(all, row.offsets), _mm256_set1_epi32(static_cast<int>(row.skipped)));
    if (_mm256_mask_cmpge_epu32_mask(all, first, end) != 0) return {};
    __m256i segment = gather(row, all, first);
    unsigned unlike = _mm256_mask_cmple_epu32_mask(all, segment, low) | unlikeFirst(segment, all);
    if (row.skipped > 0)
        unlike |= _mm256_mask_cmpgt_epu32_mask(all, gather(row, all, _mm256_sub_epi32(first, one)), low);
    AlikeEnds ends;
    ends.solidAtBegin = ends.solidAtEnd = propertyOfFirst(segment) != airProperty;
    if (unlike != 0 || (row.opens && ends.solidAtBegin)) return {};
    seen[propertyOfFirst(segment)] = 1;

    __m256i line = uniform(ends.solidAtBegin);
    bool changed = false;
    for (__m256i place = first; _mm256_mask_cmplt_epu32_mask(all, segment, high) != 0;) {
        place = _mm256_add_epi32(place, one);
        if (_mm256_mask_cmpge_epu32_mask(all, segment, high) != 0 || _mm256_mask_cmpge_epu32_mask(all, place, end) != 0)
            return {};
        const __m256i next = gather(row, all, place);
        const bool solid = propertyOfFirst(next) != airProperty;
        if (unlikeFirst(next, all) != 0 || (changed && solid != ends.solidAtEnd)) return {};
        if (solid != ends.solidAtEnd) {
            line = changesAt(row, segment, !solid);
            changed = true;
        }
        ends.solidAtEnd = solid;
        seen[propertyOfFirst(next)] = 1;
        segment = next;
    }
    _mm256_mask_storeu_epi32(lines, all, line);
    const __m512i bytes =
        _mm512_maskz_slli_epi64(all, _mm512_maskz_cvtepu32_epi64(all, first), std::countr_zero(sizeof(Segment)));
    const __m512i base = _mm512_set1_epi64(reinterpret_cast<std::int64_t>(row.segments));
    _mm512_mask_storeu_epi64(firstSegments, all, _mm512_add_epi64(base, bytes));
    return ends;
}

} // namespace

BURIN_AVX512_END
#endif

std::optional<AlikeEnds> readAlikeRow([[maybe_unused]] const AlikeRow& row, [[maybe_unused]] SurfaceLine* lines,
                                      [[maybe_unused]] const Segment** firstSegments,
                                      [[maybe_unused]] std::uint8_t* seen) noexcept {
#ifdef BURIN_AVX512
    if (hasAvx512) return readRow(row, lines, firstSegments, seen);
#endif
    return {};
}

} // namespace burin
