// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

// BURIN_VECTORISED before a function compiles it twice if the program is built for any x86-64: also for AVX2; the
// version is selected when the program is loaded. Neither uses fused multiply-add, so that both give the same bits.
// Functions called by it must be inlined (BURIN_INLINE), or they are compiled only once. Sources that use it:
// burin_vectorised in CMake. BURIN_VECTORISED_TO_AVX512 adds a third version, with mask registers and twice as many
// registers, for functions where measurements showed a benefit: the lanes and the bits stay the same. Empty for clang
// and under sanitizers, whose runtime is not initialised yet when the version is selected.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__OPTIMIZE__) &&                        \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#ifdef __AVX2__
#define BURIN_VECTORISED
#define BURIN_VECTORISED_TO_AVX512 __attribute__((target_clones("arch=x86-64-v4", "default")))
#else
#define BURIN_VECTORISED __attribute__((target_clones("avx2", "default")))
#define BURIN_VECTORISED_TO_AVX512 __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#endif
#else
#define BURIN_VECTORISED
#define BURIN_VECTORISED_TO_AVX512
#endif
#define BURIN_INLINE inline __attribute__((always_inline))

// The eight lanes are passed in registers of any width; nothing here crosses the boundary of a library.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

namespace burin {

/// Eight numbers in a vector (GCC vector extension, also supported by clang): +, -, *, /, comparisons (all bits or
/// none) and `condition ? a : b` work lane by lane. For values in registers only: their alignment depends on the target
/// of the function. In memory they are `Eight`.
using Floats = float __attribute__((vector_size(32)));
using Integers = std::int32_t __attribute__((vector_size(32)));
using Words = std::uint32_t __attribute__((vector_size(32)));
inline constexpr int lanes = 8;

/// Eight numbers in memory.
template <class Number>
struct alignas(32) Eight {
    Number lane[lanes];
    Number& operator[](int i) noexcept { return lane[i]; }
    Number operator[](int i) const noexcept { return lane[i]; }
};
using EightFloats = Eight<float>;
using EightIntegers = Eight<std::int32_t>;

BURIN_INLINE Floats load(const EightFloats& from) noexcept {
    Floats values;
    __builtin_memcpy(&values, &from, sizeof values);
    return values;
}
BURIN_INLINE Integers load(const EightIntegers& from) noexcept {
    Integers values;
    __builtin_memcpy(&values, &from, sizeof values);
    return values;
}
template <class Number, class Lanes>
BURIN_INLINE void store(const Lanes& values, Eight<Number>& to) noexcept {
    static_assert(sizeof values == sizeof to);
    __builtin_memcpy(&to, &values, sizeof to);
}

BURIN_INLINE Floats floats(float value) noexcept {
    return value - Floats{}; // a sum would have to turn -0 into +0, which costs an addition
}
BURIN_INLINE Integers integers(std::int32_t value) noexcept {
    // One move and one shuffle; Integers{} + value becomes an insertion for each lane.
    const std::int32_t __attribute__((vector_size(16))) first{value, 0, 0, 0};
    return __builtin_shufflevector(first, first, 0, 0, 0, 0, 0, 0, 0, 0);
}
BURIN_INLINE Floats least(Floats a, Floats b) noexcept {
    return a < b ? a : b;
}
BURIN_INLINE Floats most(Floats a, Floats b) noexcept {
    return a > b ? a : b;
}
BURIN_INLINE Integers least(Integers a, Integers b) noexcept {
    return a < b ? a : b;
}
BURIN_INLINE Integers most(Integers a, Integers b) noexcept {
    return a > b ? a : b;
}
/// Square roots; 0 for negative numbers.
BURIN_INLINE Floats rootsOf(Floats squares) noexcept {
    const Floats held = most(squares, Floats{});
    Floats roots;
    for (int i = 0; i < lanes; ++i) roots[i] = __builtin_sqrtf(held[i]);
    return roots;
}
/// Integral part of numbers, truncated towards 0.
BURIN_INLINE Integers wholeOf(Floats numbers) noexcept {
    return __builtin_convertvector(numbers, Integers);
}
BURIN_INLINE Floats floatsOf(Integers numbers) noexcept {
    return __builtin_convertvector(numbers, Floats);
}
/// One bit per lane of a comparison's result.
BURIN_INLINE std::uint32_t bitsOf(Integers condition) noexcept {
#ifdef __SSE2__ // available on every x86-64; the compiler does not find it by itself
    const auto low = __builtin_shufflevector(condition, condition, 0, 1, 2, 3);
    const auto high = __builtin_shufflevector(condition, condition, 4, 5, 6, 7);
    return static_cast<std::uint32_t>(_mm_movemask_ps(reinterpret_cast<__m128>(low)) |
                                      _mm_movemask_ps(reinterpret_cast<__m128>(high)) << 4);
#else
    std::uint32_t bits = 0;
    for (int i = 0; i < lanes; ++i) bits |= static_cast<std::uint32_t>(condition[i] & 1 << i);
    return bits;
#endif
}

/// Whether a comparison holds in any lane.
BURIN_INLINE bool anyOf(Integers condition) noexcept {
#ifdef __SSE2__
    const auto low = __builtin_shufflevector(condition, condition, 0, 1, 2, 3);
    const auto high = __builtin_shufflevector(condition, condition, 4, 5, 6, 7);
    return _mm_movemask_ps(reinterpret_cast<__m128>(low | high)) != 0;
#else
    return bitsOf(condition) != 0;
#endif
}
/// Absolute values.
BURIN_INLINE Floats magnitudes(Floats numbers) noexcept {
    return reinterpret_cast<Floats>(reinterpret_cast<Integers>(numbers) & integers(0x7fffffff));
}

} // namespace burin
