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

/// Where lines begin to be read. Behind the last of fewer than eight lines stands the first again.
struct alignas(32) Firsts {
    std::uint32_t at[8];
};
/// One segment of each line: so many behind the first. Loaded one by one, which is faster than a gathering load on
/// the processors that were measured.
BURIN_INLINE __m256i segmentsAt(const AlikeRow& row, const Firsts& firsts, std::ptrdiff_t behind) noexcept {
    const auto at = [&](int line) noexcept {
        std::int32_t segment;
        __builtin_memcpy(&segment, row.segments + firsts.at[line] + behind, sizeof segment);
        return segment;
    };
    return _mm256_setr_epi32(at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7));
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

bool readRow(const AlikeRow& row, SurfaceLine* lines, const Segment** firstSegments, std::uint8_t* seen,
             SurfaceChanges& changes) noexcept {
    const auto all = static_cast<__mmask8>((1U << row.count) - 1);
    const __m256i end = _mm256_maskz_loadu_epi32(all, row.offsets + 1), one = _mm256_set1_epi32(1);
    const __m256i low = _mm256_set1_epi32(static_cast<int>(row.low)),
                  high = _mm256_set1_epi32(static_cast<int>(row.high));
    const __m256i first =
        _mm256_add_epi32(_mm256_maskz_loadu_epi32(all, row.offsets), _mm256_set1_epi32(static_cast<int>(row.skipped)));
    if (_mm256_mask_cmpge_epu32_mask(all, first, end) != 0) return false;
    Firsts firsts;
    _mm256_store_si256(reinterpret_cast<__m256i*>(firsts.at),
                       _mm256_mask_blend_epi32(all, _mm256_broadcastd_epi32(_mm256_castsi256_si128(first)), first));
    __m256i segment = segmentsAt(row, firsts, 0);
    unsigned unlike = _mm256_mask_cmple_epu32_mask(all, segment, low) | unlikeFirst(segment, all);
    if (row.skipped > 0) unlike |= _mm256_mask_cmpgt_epu32_mask(all, segmentsAt(row, firsts, -1), low);
    const bool solidAtBegin = propertyOfFirst(segment) != airProperty;
    bool solidAtEnd = solidAtBegin;
    if (unlike != 0 || (row.opens && solidAtBegin)) return false;
    seen[propertyOfFirst(segment)] = 1;

    __m256i line = uniform(solidAtBegin);
    bool changed = false;
    __m256i place = first;
    for (std::ptrdiff_t behind = 1; _mm256_mask_cmplt_epu32_mask(all, segment, high) != 0; ++behind) {
        place = _mm256_add_epi32(place, one);
        if (_mm256_mask_cmpge_epu32_mask(all, segment, high) != 0 || _mm256_mask_cmpge_epu32_mask(all, place, end) != 0)
            return false;
        const __m256i next = segmentsAt(row, firsts, behind);
        const bool solid = propertyOfFirst(next) != airProperty;
        if (unlikeFirst(next, all) != 0 || (changed && solid != solidAtEnd)) return false;
        if (solid != solidAtEnd) {
            line = changesAt(row, segment, !solid);
            changed = true;
        }
        solidAtEnd = solid;
        seen[propertyOfFirst(next)] = 1;
        segment = next;
    }
    _mm256_mask_storeu_epi32(lines, all, line);
    const __m512i bytes =
        _mm512_maskz_slli_epi64(all, _mm512_maskz_cvtepu32_epi64(all, first), std::countr_zero(sizeof(Segment)));
    const __m512i base = _mm512_set1_epi64(reinterpret_cast<std::int64_t>(row.segments));
    _mm512_mask_storeu_epi64(firstSegments, all, _mm512_add_epi64(base, bytes));
    changes.atBegin |= SurfaceChanges::bitOf(solidAtBegin);
    changes.atEnd |= SurfaceChanges::bitOf(solidAtEnd);
    return true;
}

} // namespace

BURIN_AVX512_END
#endif

bool readAlikeRow([[maybe_unused]] const AlikeRow& row, [[maybe_unused]] SurfaceLine* lines,
                  [[maybe_unused]] const Segment** firstSegments, [[maybe_unused]] std::uint8_t* seen,
                  [[maybe_unused]] SurfaceChanges& changes) noexcept {
#ifdef BURIN_AVX512
    if (hasAvx512) return readRow(row, lines, firstSegments, seen, changes);
#endif
    return false;
}

} // namespace burin
