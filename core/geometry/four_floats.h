// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace burin {

/// Four floats in one SIMD register: SSE2, which every x86-64 has.
using FourFloats = float __attribute__((vector_size(16)));
using FourInts = int __attribute__((vector_size(16)));

inline FourFloats fourAt(const float* first) noexcept {
    FourFloats vector;
    std::memcpy(&vector, first, sizeof vector);
    return vector;
}
inline void put(const FourFloats& vector, float* first) noexcept {
    std::memcpy(first, &vector, sizeof vector);
}
inline FourFloats greater(const FourFloats& a, const FourFloats& b) noexcept {
    return a > b ? a : b;
}
inline FourFloats absolute(const FourFloats& a) noexcept {
    return greater(a, -a);
}
inline FourFloats rootsOf(const FourFloats& a) noexcept {
#ifdef __SSE2__ // available on every x86-64; the compiler does not find it by itself
    return _mm_sqrt_ps(a);
#else
    return FourFloats{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
}
/// Length of the parts of four vectors perpendicular to unit vectors; computed by components, because one minus a
/// square would lose half of the digits.
inline FourFloats partAcross(const std::array<FourFloats, 3>& of, const std::array<FourFloats, 3>& unit,
                             const FourFloats& along) noexcept {
    FourFloats square{};
    for (std::size_t i = 0; i < 3; ++i) {
        const FourFloats across = of[i] - along * unit[i];
        square += across * across;
    }
    return rootsOf(square) + 1e-6F;
}
inline float greatest(const FourFloats& a) noexcept {
    return std::max(std::max(a[0], a[1]), std::max(a[2], a[3]));
}

} // namespace burin
