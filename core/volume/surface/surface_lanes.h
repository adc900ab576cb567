// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/vectorised.h"

#include <cstddef>
#include <cstdint>

namespace burin {

/// Sixteen nodes of a surface's field side by side; only for values in registers, as `Floats`.
using Nodes = std::int16_t __attribute__((vector_size(32)));
inline constexpr int nodeLanes = 16;

BURIN_INLINE Nodes loadNodes(const std::int16_t* from) noexcept {
    Nodes values;
    __builtin_memcpy(&values, from, sizeof values);
    return values;
}
BURIN_INLINE void storeNodes(Nodes values, std::int16_t* to) noexcept {
    __builtin_memcpy(to, &values, sizeof values);
}
BURIN_INLINE Nodes nodes(std::int16_t value) noexcept {
    return Nodes{} + value;
}
/// One bit for each of sixteen nodes: set if it is below 0.
BURIN_INLINE std::uint64_t negative(Nodes values) noexcept {
#ifdef __SSE2__ // available on every x86-64; the compiler does not find it by itself
    const auto low = __builtin_shufflevector(values, values, 0, 1, 2, 3, 4, 5, 6, 7);
    const auto high = __builtin_shufflevector(values, values, 8, 9, 10, 11, 12, 13, 14, 15);
    const __m128i bytes = _mm_packs_epi16(reinterpret_cast<__m128i>(low), reinterpret_cast<__m128i>(high));
    return static_cast<std::uint32_t>(_mm_movemask_epi8(bytes));
#else
    std::uint64_t bits = 0;
    for (int i = 0; i < nodeLanes; ++i) bits |= std::uint64_t{values[i] < 0} << i;
    return bits;
#endif
}

} // namespace burin
