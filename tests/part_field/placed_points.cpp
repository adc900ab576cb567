// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/part_field/placed_points.h"

#include "core/base/avx512.h"
#include "tests/part_field/part_field_layers.h"

#include <cstring>

namespace burin {

namespace {

static_assert(sizeof(glm::dvec3) == 3 * sizeof(double) && PlacedPoints::together == lanes);

/// A number of voxels in fixed point: adding this constant to a double leaves 32 fractional bits in the lower word, and
/// the whole voxels above them, in the upper word.
constexpr double fixedPoint = 1.5 * (1 << 20);
constexpr std::uint32_t fixedPointUpper = 0x41380000;

/// For eight points: whole voxels, and their fractions in units of 2^-32. For a position below the layers' low side, or
/// one that is not a number, the voxel is huge.
struct FixedPlaces {
    std::array<Words, 3> voxel, share;
};

template <class Lanes>
BURIN_INLINE void store(const Lanes& values, void* to) noexcept {
    std::memcpy(to, &values, sizeof values);
}

/// State carried from eight points to the next eight.
struct SoFar {
    std::array<Words, 3> brick; ///< of the last eight
    Words outside{};            ///< highest bit: one of the points is outside
};

/// Stores the positions of eight points, starting at one of them.
/// @param voxels number along each axis
BURIN_INLINE void keep(const FixedPlaces& places, std::size_t from, const std::array<std::uint32_t, 3>& voxels,
                       PlacedPoints& placed, SoFar& soFar) noexcept {
    Integers first{};
    Words unlike{};
    for (std::size_t axis = 3; axis-- > 0;) {
        const Words voxel = places.voxel[axis], brick = voxel >> 3;
        soFar.outside |= voxel | ~(voxel - voxels[axis]);
        const auto cell = reinterpret_cast<Integers>(voxel & (CellGrid::cells - 1));
        const Floats share = floatsOf(reinterpret_cast<Integers>(places.share[axis] >> 8)) * 0x1p-24F;
        store(share, placed.share[axis].data() + from);
        store(floatsOf(cell) + share, placed.along[axis].data() + from);
        store(brick, placed.brick[axis].data() + from);
        first = CellGrid::along * first + cell;
        const Words before = from == 0 ? brick : soFar.brick[axis];
        unlike |= brick ^ __builtin_shufflevector(before, brick, 7, 8, 9, 10, 11, 12, 13, 14);
        soFar.brick[axis] = brick;
    }
    store(first, placed.first.data() + from);
    placed.begins[from / lanes] = static_cast<std::uint8_t>(bitsOf(unlike != Words{}));
}
namespace any_processor {

using TwoDoubles = double __attribute__((vector_size(16)));
using FourDoubles = double __attribute__((vector_size(32)));

/// Two numbers from each of two addresses.
BURIN_INLINE FourDoubles pairs(const double* low, const double* high) noexcept {
    TwoDoubles first, second;
    std::memcpy(&first, low, sizeof first);
    std::memcpy(&second, high, sizeof second);
    return __builtin_shufflevector(first, second, 0, 1, 2, 3);
}

/// One word of each of eight points, by axis.
/// @param at in the lower halves x0 y0 z0 x1, y1 z1 x2 y2, z2 x3 y3 z3, in the upper ones likewise points 4 … 7
BURIN_INLINE std::array<Words, 3> byAxis(const std::array<Words, 3>& at) noexcept {
    const Words xy = __builtin_shufflevector(at[1], at[2], 2, 3, 9, 10, 6, 7, 13, 14);
    const Words yz = __builtin_shufflevector(at[0], at[1], 1, 2, 8, 9, 5, 6, 12, 13);
    return {__builtin_shufflevector(at[0], xy, 0, 3, 8, 10, 4, 7, 12, 14),
            __builtin_shufflevector(yz, xy, 0, 2, 9, 11, 4, 6, 13, 15),
            __builtin_shufflevector(yz, at[2], 1, 3, 8, 11, 5, 7, 12, 15)};
}

/// A copy of a frame that the compiler can keep in registers, because nothing written can alias it.
struct Registers {
    explicit Registers(const FieldFrame& frame) noexcept
        : origin{pairs(&frame.origin[0], &frame.origin[0]), pairs(&frame.origin[2], &frame.origin[2]),
                 pairs(&frame.origin[1], &frame.origin[1])}
        , perVoxel(FourDoubles{} + frame.perVoxel) {}
    std::array<FourDoubles, 3> origin;
    FourDoubles perVoxel;
};

/// For eight consecutive points.
BURIN_INLINE FixedPlaces eightPlaces(const double* points, const Registers& frame) noexcept {
    std::array<Words, 3> lower, upper;
    const auto placed = [&](std::size_t pair) noexcept {
        const FourDoubles way = pairs(points + 2 * pair, points + 12 + 2 * pair) - frame.origin[pair % 3];
        return reinterpret_cast<Words>(way * frame.perVoxel + fixedPoint);
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const Words one = placed(2 * i), next = placed(2 * i + 1);
        lower[i] = __builtin_shufflevector(one, next, 0, 2, 8, 10, 4, 6, 12, 14);
        upper[i] = __builtin_shufflevector(one, next, 1, 3, 9, 11, 5, 7, 13, 15) - fixedPointUpper;
    }
    return {byAxis(upper), byAxis(lower)};
}

BURIN_VECTORISED bool place(const glm::dvec3* points, std::size_t count, const FieldFrame& frame,
                            PlacedPoints& placed) noexcept {
    const Registers registers(frame);
    const std::array<std::uint32_t, 3> voxels = frame.voxels;
    SoFar soFar;
    for (std::size_t from = 0; from < count; from += lanes)
        keep(eightPlaces(&points[from].x, registers), from, voxels, placed, soFar);
    placed.begins[0] |= 1;
    return !anyOf(reinterpret_cast<Integers>(soFar.outside) < 0);
}

} // namespace any_processor

#ifdef BURIN_AVX512
BURIN_AVX512_BEGIN
namespace avx512 { // the same with all eight numbers of a register side by side

using EightDoubles = double __attribute__((vector_size(64)));
using SixteenWords = std::uint32_t __attribute__((vector_size(64)));

BURIN_INLINE EightDoubles eightAt(const double* numbers) noexcept {
    EightDoubles eight;
    std::memcpy(&eight, numbers, sizeof eight);
    return eight;
}

struct Registers {
    explicit Registers(const FieldFrame& frame) noexcept
        : origin{eightAt(&frame.origin[0]), eightAt(&frame.origin[2]), eightAt(&frame.origin[1])}
        , perVoxel(EightDoubles{} + frame.perVoxel) {}
    std::array<EightDoubles, 3> origin;
    EightDoubles perVoxel;
};

BURIN_INLINE SixteenWords placed(const double* points, EightDoubles origin, EightDoubles perVoxel) noexcept {
    return reinterpret_cast<SixteenWords>((eightAt(points) - origin) * perVoxel + fixedPoint);
}

BURIN_INLINE Words upperHalf(SixteenWords words) noexcept {
    return __builtin_shufflevector(words, words, 8, 9, 10, 11, 12, 13, 14, 15);
}
BURIN_INLINE Words lowerHalf(SixteenWords words) noexcept {
    return __builtin_shufflevector(words, words, 0, 1, 2, 3, 4, 5, 6, 7);
}

BURIN_INLINE FixedPlaces eightPlaces(const double* points, const Registers& frame) noexcept {
    const SixteenWords a = placed(points, frame.origin[0], frame.perVoxel),
                       b = placed(points + 8, frame.origin[1], frame.perVoxel),
                       c = placed(points + 16, frame.origin[2], frame.perVoxel);
    // In the lower half the upper words of the eight numbers of an axis, and the lower words in the upper half.
    const SixteenWords x =
        __builtin_shufflevector(__builtin_shufflevector(a, b, 1, 7, 13, 19, 25, 31, 0, 0, 0, 6, 12, 18, 24, 30, 0, 0),
                                c, 0, 1, 2, 3, 4, 5, 21, 27, 8, 9, 10, 11, 12, 13, 20, 26);
    const SixteenWords y =
        __builtin_shufflevector(__builtin_shufflevector(a, b, 3, 9, 15, 21, 27, 0, 0, 0, 2, 8, 14, 20, 26, 0, 0, 0), c,
                                0, 1, 2, 3, 4, 17, 23, 29, 8, 9, 10, 11, 12, 16, 22, 28);
    const SixteenWords z =
        __builtin_shufflevector(__builtin_shufflevector(a, b, 5, 11, 17, 23, 29, 0, 0, 0, 4, 10, 16, 22, 28, 0, 0, 0),
                                c, 0, 1, 2, 3, 4, 19, 25, 31, 8, 9, 10, 11, 12, 18, 24, 30);
    return {{lowerHalf(x) - fixedPointUpper, lowerHalf(y) - fixedPointUpper, lowerHalf(z) - fixedPointUpper},
            {upperHalf(x), upperHalf(y), upperHalf(z)}};
}

bool place(const glm::dvec3* points, std::size_t count, const FieldFrame& frame, PlacedPoints& placed) noexcept {
    const Registers registers(frame);
    const std::array<std::uint32_t, 3> voxels = frame.voxels;
    SoFar soFar;
    for (std::size_t from = 0; from < count; from += lanes)
        keep(eightPlaces(&points[from].x, registers), from, voxels, placed, soFar);
    placed.begins[0] |= 1;
    return !anyOf(reinterpret_cast<Integers>(soFar.outside) < 0);
}

} // namespace avx512
BURIN_AVX512_END
#endif

} // namespace

bool placePoints(const glm::dvec3* points, std::size_t count, const FieldFrame& frame, PlacedPoints& placed) noexcept {
#ifdef BURIN_AVX512
    if (hasAvx512) return avx512::place(points, count, frame, placed);
#endif
    return any_processor::place(points, count, frame, placed);
}

} // namespace burin
