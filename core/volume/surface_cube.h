// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <emmintrin.h>

namespace burin {

// What surface nets work out of the nodes around one cube, four numbers at a time with what every x86-64 processor has
// (SSE2). n counts along the runs. Four corners of one v lie in the order (u, n) = (0, 0), (0, 1), (1, 0), (1, 1). No
// branches: which edges the surface crosses can't be foreseen.

/// The columns of nodes around a cube, 4 × 4, each from the node before the cube's lower one on.
class CubeColumns {
public:
    /// @param first  the column before the cube's along u and v, at the node before the cube's
    /// @param stepU, stepV  from column to column
    CubeColumns(const std::uint16_t* first, std::size_t stepU, std::size_t stepV) noexcept
        : first_(first), stepU_(stepU), stepV_(stepV) {}

    /// In the middle of the crossings on the cube's twelve edges; 0 … 1 along u, v and the runs.
    glm::vec3 middleOfCrossings(std::uint16_t half) const noexcept {
        const __m128i low = pairs(1), high = pairs(2); // of v
        const __m128 v0 = _mm_cvtepi32_ps(low), v1 = _mm_cvtepi32_ps(high), middle = _mm_set1_ps(half);
        const __m128 in0 = _mm_cmpge_ps(v0, middle), in1 = _mm_cmpge_ps(v1, middle);
        const __m128 one = _mm_set1_ps(1.0F);
        // Edges along v join the two as they are; for those along u and n, halves of both are put together.
        const Crossing alongV = crossing(v0, v1, in0, in1, middle);
        const auto lowU = [](__m128 a, __m128 b) { return _mm_movelh_ps(a, b); };  // (v, n) at u = 0
        const auto highU = [](__m128 a, __m128 b) { return _mm_movehl_ps(b, a); }; // at u = 1
        const Crossing alongU = crossing(lowU(v0, v1), highU(v0, v1), lowU(in0, in1), highU(in0, in1), middle);
        const auto lowN = [](__m128 a, __m128 b) { return _mm_shuffle_ps(a, b, _MM_SHUFFLE(2, 0, 2, 0)); }; // (v, u)
        const auto highN = [](__m128 a, __m128 b) { return _mm_shuffle_ps(a, b, _MM_SHUFFLE(3, 1, 3, 1)); };
        const Crossing alongN = crossing(lowN(v0, v1), highN(v0, v1), lowN(in0, in1), highN(in0, in1), middle);
        const __m128 upper = _mm_set_ps(1.0F, 1.0F, 0.0F, 0.0F), odd = _mm_set_ps(1.0F, 0.0F, 1.0F, 0.0F);
        __m128 sumU = add(alongU.place, _mm_and_ps(alongV.is, upper), _mm_and_ps(alongN.is, odd));
        __m128 sumV = add(alongV.place, _mm_and_ps(alongU.is, upper), _mm_and_ps(alongN.is, upper));
        __m128 sumN = add(alongN.place, _mm_and_ps(alongU.is, odd), _mm_and_ps(alongV.is, odd));
        __m128 count = add(_mm_and_ps(alongU.is, one), _mm_and_ps(alongV.is, one), _mm_and_ps(alongN.is, one));
        _MM_TRANSPOSE4_PS(sumU, sumV, sumN, count);
        const __m128 sums = _mm_add_ps(_mm_add_ps(sumU, sumV), _mm_add_ps(sumN, count));
        alignas(16) float result[4];
        _mm_store_ps(result, _mm_div_ps(sums, _mm_shuffle_ps(sums, sums, _MM_SHUFFLE(3, 3, 3, 3))));
        return {result[0], result[1], result[2]};
    }

    /// Downhill in the field at a place in the cube, unit length: the field averaged 1-2-1 along all axes at the cube's
    /// corners, interpolated between them. That is wider than what places the point, because the eye takes a ripple of
    /// the normals for a ripple of the surface.
    /// @param shift makes the field's values fit 12 bits
    glm::vec3 outwards(const glm::vec3& place, std::uint16_t half, int shift) const noexcept {
        // Two columns beside each other along u in one register, four nodes each.
        __m128i left[4], right[4];
        for (std::size_t v = 0; v < 4; ++v) {
            left[v] = centred(two(0, v), half, shift);
            right[v] = centred(two(2, v), half, shift);
        }
        const __m128 s0 = smoothed(smooth(left[0], left[1], left[2]), smooth(right[0], right[1], right[2]));
        const __m128 s1 = smoothed(smooth(left[1], left[2], left[3]), smooth(right[1], right[2], right[3]));

        alignas(16) float mean[4], rise[4];
        _mm_store_ps(mean, _mm_add_ps(s0, _mm_mul_ps(_mm_set1_ps(place[1]), _mm_sub_ps(s1, s0))));
        _mm_store_ps(rise, _mm_sub_ps(s1, s0));
        const float u = place[0], n = place[2];
        const auto between = [](float a, float b, float share) { return a + share * (b - a); };
        const glm::vec3 gradient(between(mean[2] - mean[0], mean[3] - mean[1], n),
                                 between(between(rise[0], rise[1], n), between(rise[2], rise[3], n), u),
                                 between(mean[1] - mean[0], mean[3] - mean[2], u));
        const float square = glm::dot(gradient, gradient);
        return square > 0.0F ? -gradient / std::sqrt(square) : glm::vec3(0.0F, 0.0F, 1.0F);
    }

private:
    struct Crossing {
        __m128 place, is; ///< 0 … 1 along the edge where it is crossed; all bits where it is
    };

    static __m128 add(__m128 a, __m128 b, __m128 c) noexcept { return _mm_add_ps(_mm_add_ps(a, b), c); }
    static Crossing crossing(__m128 low, __m128 high, __m128 lowInside, __m128 highInside, __m128 half) noexcept {
        const __m128 is = _mm_xor_ps(lowInside, highInside);
        const __m128 place = _mm_div_ps(_mm_sub_ps(half, low), _mm_sub_ps(high, low)); // 0 / 0 where it is not
        return {_mm_and_ps(place, is), is};
    }
    /// Nodes n and n + 1 of the cube's two columns at `v`, widened.
    __m128i pairs(std::size_t v) const noexcept {
        const auto load = [&](std::size_t u) {
            std::int32_t pair = 0;
            std::memcpy(&pair, first_ + u * stepU_ + v * stepV_ + 1, sizeof pair);
            return _mm_cvtsi32_si128(pair);
        };
        return _mm_unpacklo_epi16(_mm_unpacklo_epi32(load(1), load(2)), _mm_setzero_si128());
    }
    __m128i two(std::size_t u, std::size_t v) const noexcept {
        const std::uint16_t* const at = first_ + u * stepU_ + v * stepV_;
        return _mm_unpacklo_epi64(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(at)),
                                  _mm_loadl_epi64(reinterpret_cast<const __m128i*>(at + stepU_)));
    }
    static __m128i centred(__m128i values, std::uint16_t half, int shift) noexcept {
        return _mm_srai_epi16(_mm_sub_epi16(values, _mm_set1_epi16(static_cast<short>(half))), shift);
    }
    static __m128i smooth(__m128i before, __m128i at, __m128i behind) noexcept {
        return _mm_adds_epi16(_mm_adds_epi16(before, behind), _mm_adds_epi16(at, at));
    }
    /// Averages along u, then along the runs; the cube's four corners at one v.
    static __m128 smoothed(__m128i left, __m128i right) noexcept {
        const __m128i middle = _mm_castpd_si128(_mm_shuffle_pd(_mm_castsi128_pd(left), _mm_castsi128_pd(right), 1));
        const __m128i columns = smooth(left, middle, right);
        const __m128i lower = _mm_madd_epi16(columns, _mm_set_epi16(0, 1, 2, 1, 0, 1, 2, 1));
        const __m128i upper = _mm_madd_epi16(columns, _mm_set_epi16(1, 2, 1, 0, 1, 2, 1, 0));
        // Each holds two parts a column; their sums, by column and node.
        const __m128 low = _mm_castsi128_ps(lower), high = _mm_castsi128_ps(upper);
        const __m128i first = _mm_castps_si128(_mm_shuffle_ps(low, high, _MM_SHUFFLE(2, 0, 2, 0)));
        const __m128i second = _mm_castps_si128(_mm_shuffle_ps(low, high, _MM_SHUFFLE(3, 1, 3, 1)));
        const __m128i sums = _mm_add_epi32(first, second); // n of both columns, then n + 1 of both
        return _mm_cvtepi32_ps(_mm_shuffle_epi32(sums, _MM_SHUFFLE(3, 1, 2, 0)));
    }

    const std::uint16_t* first_;
    std::size_t stepU_, stepV_;
};

} // namespace burin
