// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/vectorised.h"
#include "core/field/part_field_layers.h"

#include <algorithm>
#include <cstring>

namespace burin {

namespace {

constexpr std::size_t chunkPoints = 64;
template <class Number>
using Row = std::array<Number, chunkPoints>;

/// Points side by side: placed and computed eight at a time, looked up one by one in between.
struct Chunk {
    std::array<Row<float>, 3> share;        ///< of the cell
    std::array<Row<float>, 3> along;        ///< voxels from the brick's lowest corner
    std::array<Row<std::int32_t>, 3> brick; ///< counted from the origin
    Row<std::int32_t> first;                ///< of the cell's samples in the brick
    Row<const FineBrick*> header;
    Row<const std::int8_t*> narrow; ///< residuals at the cell's lowest corner; of a brick with wide ones none
    Row<const std::int16_t*> wide;
};

struct Frame {
    glm::dvec3 origin, voxelCount;
    double perVoxel;
};

using TwoDoubles = double __attribute__((vector_size(16)));
using FourDoubles = double __attribute__((vector_size(32)));
using FourFloats = float __attribute__((vector_size(16)));

/// Two numbers from each of two places.
BURIN_INLINE FourDoubles pairs(const double* low, const double* high) noexcept {
    TwoDoubles first, second;
    std::memcpy(&first, low, sizeof first);
    std::memcpy(&second, high, sizeof second);
    return __builtin_shufflevector(first, second, 0, 1, 2, 3);
}

/// One coordinate of eight points: of 0, 1, 4, 5, and of 2, 3, 6, 7, which needs no exchange between halves.
struct Coordinate {
    FourDoubles low, high;
};
BURIN_INLINE std::array<Coordinate, 3> coordinates(const double* p) noexcept {
    const FourDoubles a = pairs(p, p + 12), b = pairs(p + 2, p + 14), c = pairs(p + 4, p + 16),
                      d = pairs(p + 6, p + 18), e = pairs(p + 8, p + 20), f = pairs(p + 10, p + 22);
    return {Coordinate{__builtin_shufflevector(a, b, 0, 5, 2, 7), __builtin_shufflevector(d, e, 0, 5, 2, 7)},
            Coordinate{__builtin_shufflevector(a, c, 1, 4, 3, 6), __builtin_shufflevector(d, f, 1, 4, 3, 6)},
            Coordinate{__builtin_shufflevector(b, c, 0, 5, 2, 7), __builtin_shufflevector(e, f, 0, 5, 2, 7)}};
}

/// Whole part and share of numbers that are not negative, and below 2^31.
struct Split {
    FourDoubles whole, share;
};
constexpr double wholeBits = 6755399441055744.0; // 1.5 * 2^52: a double that is added to it loses its fraction
BURIN_INLINE Split split(FourDoubles number) noexcept {
    const FourDoubles nearest = (number + wholeBits) - wholeBits;
    const FourDoubles whole = nearest - (nearest > number ? FourDoubles{} + 1.0 : FourDoubles{});
    return {whole, number - whole};
}
BURIN_INLINE Integers integersOf(FourDoubles low, FourDoubles high) noexcept {
    const FourDoubles a = low + wholeBits, b = high + wholeBits;
    return __builtin_shufflevector(reinterpret_cast<Integers>(a), reinterpret_cast<Integers>(b), 0, 2, 8, 10, 4, 6, 12,
                                   14);
}
BURIN_INLINE Floats narrowed(FourDoubles low, FourDoubles high) noexcept {
    const Floats both = __builtin_shufflevector(__builtin_convertvector(low, FourFloats),
                                                __builtin_convertvector(high, FourFloats), 0, 1, 2, 3, 4, 5, 6, 7);
    return __builtin_shufflevector(both, both, 0, 1, 4, 5, 2, 3, 6, 7);
}

template <class Lanes>
BURIN_INLINE void store(const Lanes& values, void* to) noexcept {
    std::memcpy(to, &values, sizeof values);
}

/// @return whether all of them are in the box of the layers; if not, the chunk is of no use
BURIN_VECTORISED_TO_AVX512 bool placeAll(const glm::dvec3* points, const Frame& frame, Chunk& chunk) noexcept {
    static_assert(sizeof(glm::dvec3) == 3 * sizeof(double));
    auto inside = FourDoubles{} == FourDoubles{};
    for (std::size_t from = 0; from < chunkPoints; from += lanes) {
        const std::array<Coordinate, 3> of = coordinates(&points[from].x);
        Integers first{};
        for (int axis = 2; axis >= 0; --axis) {
            const auto a = static_cast<std::size_t>(axis);
            const auto place = [&](FourDoubles coordinate) noexcept {
                const FourDoubles wanted = (coordinate - frame.origin[axis]) * frame.perVoxel;
                inside &= (wanted >= FourDoubles{}) & (wanted < frame.voxelCount[axis]);
                return wanted;
            };
            const Split low = split(place(of[a].low)), high = split(place(of[a].high));
            const Integers voxel = integersOf(low.whole, high.whole), cell = voxel & (CellGrid::cells - 1);
            const Floats share = narrowed(low.share, high.share);
            store(share, chunk.share[a].data() + from);
            store(floatsOf(cell) + share, chunk.along[a].data() + from);
            store(voxel >> 3, chunk.brick[a].data() + from);
            first = CellGrid::along * first + cell;
        }
        store(first, chunk.first.data() + from);
    }
    return (inside[0] & inside[1] & inside[2] & inside[3]) != 0;
}

/// The eight corners of a cell, x running fastest, of eight cells.
struct Corners {
    std::array<Floats, 8> of;
};

/// Two residuals that follow each other come with one load; what lies beyond them is still in the brick's store.
BURIN_INLINE std::int32_t wordAt(const std::int8_t* first) noexcept {
    std::int32_t word;
    std::memcpy(&word, first, sizeof word);
    return word;
}
BURIN_INLINE void gatherNarrow(const std::int8_t* const* first, Corners& corners) noexcept {
    constexpr std::array<int, 4> steps{0, 9, 81, 90};
    for (std::size_t i = 0; i < 4; ++i) {
        const int step = steps[i];
        const Integers words{wordAt(first[0] + step), wordAt(first[1] + step), wordAt(first[2] + step),
                             wordAt(first[3] + step), wordAt(first[4] + step), wordAt(first[5] + step),
                             wordAt(first[6] + step), wordAt(first[7] + step)};
        corners.of[2 * i] = floatsOf((words << 24) >> 24); // x86: the lowest byte is the first
        corners.of[2 * i + 1] = floatsOf((words << 16) >> 24);
    }
}
BURIN_INLINE void gatherAny(const Chunk& chunk, std::size_t from, Corners& corners) noexcept {
    constexpr std::array<int, 8> steps{0, 1, 9, 10, 81, 82, 90, 91};
    std::array<EightIntegers, 8> found;
    for (std::size_t lane = 0; lane < lanes; ++lane)
        for (std::size_t i = 0; i < 8; ++i)
            found[i][static_cast<int>(lane)] = chunk.narrow[from + lane] != nullptr
                                                   ? chunk.narrow[from + lane][steps[i]]
                                                   : chunk.wide[from + lane][steps[i]];
    for (std::size_t i = 0; i < 8; ++i) corners.of[i] = floatsOf(load(found[i]));
}

/// Headers of the bricks of eight cells.
struct Headers {
    Floats base, quantum;
    std::array<Floats, 3> slope;
};
template <class Member>
BURIN_INLINE Floats ofEach(const FineBrick* const* header, const Member& member) noexcept {
    return Floats{member(*header[0]), member(*header[1]), member(*header[2]), member(*header[3]),
                  member(*header[4]), member(*header[5]), member(*header[6]), member(*header[7])};
}
BURIN_INLINE Headers headersOf(const FineBrick* const* header) noexcept {
    return {ofEach(header, [](const FineBrick& brick) { return brick.base; }),
            ofEach(header, [](const FineBrick& brick) { return brick.quantum; }),
            {ofEach(header, [](const FineBrick& brick) { return brick.slope[0]; }),
             ofEach(header, [](const FineBrick& brick) { return brick.slope[1]; }),
             ofEach(header, [](const FineBrick& brick) { return brick.slope[2]; })}};
}
BURIN_INLINE Headers headersOf(const FineBrick& brick) noexcept {
    return {floats(brick.base),
            floats(brick.quantum),
            {floats(brick.slope[0]), floats(brick.slope[1]), floats(brick.slope[2])}};
}

BURIN_INLINE Floats floatsAt(const float* first) noexcept {
    Floats values;
    std::memcpy(&values, first, sizeof values);
    return values;
}

BURIN_INLINE Floats mixed(Floats a, Floats b, Floats share) noexcept {
    return a + share * (b - a);
}

/// Lane by lane as they are answered.
BURIN_INLINE void put(Floats distance, Floats x, Floats y, Floats z, PartDistance* answers) noexcept {
    static_assert(sizeof(PartDistance) == 4 * sizeof(float));
    const Floats lower0 = __builtin_shufflevector(distance, x, 0, 8, 1, 9, 4, 12, 5, 13);
    const Floats upper0 = __builtin_shufflevector(distance, x, 2, 10, 3, 11, 6, 14, 7, 15);
    const Floats lower1 = __builtin_shufflevector(y, z, 0, 8, 1, 9, 4, 12, 5, 13);
    const Floats upper1 = __builtin_shufflevector(y, z, 2, 10, 3, 11, 6, 14, 7, 15);
    const std::array<Floats, 4> rows{__builtin_shufflevector(lower0, lower1, 0, 1, 8, 9, 4, 5, 12, 13),
                                     __builtin_shufflevector(lower0, lower1, 2, 3, 10, 11, 6, 7, 14, 15),
                                     __builtin_shufflevector(upper0, upper1, 0, 1, 8, 9, 4, 5, 12, 13),
                                     __builtin_shufflevector(upper0, upper1, 2, 3, 10, 11, 6, 7, 14, 15)};
    for (std::size_t i = 0; i < 4; ++i) { // lanes i and i + 4
        const FourFloats low = __builtin_shufflevector(rows[i], rows[i], 0, 1, 2, 3);
        const FourFloats high = __builtin_shufflevector(rows[i], rows[i], 4, 5, 6, 7);
        std::memcpy(static_cast<void*>(answers + i), &low, sizeof low);
        std::memcpy(static_cast<void*>(answers + i + 4), &high, sizeof high);
    }
}

BURIN_INLINE void computeGroup(const Chunk& chunk, std::size_t from, const Corners& corners, const Headers& headers,
                               Floats perVoxel, PartDistance* answers) noexcept {
    const std::array<Floats, 8>& c = corners.of;
    const Floats x = floatsAt(chunk.share[0].data() + from), y = floatsAt(chunk.share[1].data() + from),
                 z = floatsAt(chunk.share[2].data() + from);
    const Floats low0 = mixed(c[0], c[4], z), low1 = mixed(c[1], c[5], z), high0 = mixed(c[2], c[6], z),
                 high1 = mixed(c[3], c[7], z);
    const Floats alongX = mixed(low1 - low0, high1 - high0, y);
    const Floats y0 = mixed(low0, low1, x), y1 = mixed(high0, high1, x);
    const Floats alongZ = mixed(mixed(c[4] - c[0], c[5] - c[1], x), mixed(c[6] - c[2], c[7] - c[3], x), y);
    const auto& [base, quantum, slope] = headers;
    const Floats plane = slope[0] * floatsAt(chunk.along[0].data() + from) +
                         slope[1] * floatsAt(chunk.along[1].data() + from) +
                         slope[2] * floatsAt(chunk.along[2].data() + from);
    put(base + plane + quantum * mixed(y0, y1, y), (slope[0] + quantum * alongX) * perVoxel,
        (slope[1] + quantum * (y1 - y0)) * perVoxel, (slope[2] + quantum * alongZ) * perVoxel, answers);
}

/// A bit a group of eight.
struct Groups {
    std::uint32_t wide = 0;  ///< some of its bricks have residuals of 16 bits
    std::uint32_t mixed = 0; ///< it is of several bricks
};

BURIN_VECTORISED_TO_AVX512 void computeAll(const Chunk& chunk, const Groups& groups, float perVoxel,
                                 PartDistance* answers) noexcept {
    const Floats scale = floats(perVoxel);
    for (std::size_t from = 0; from < chunkPoints; from += lanes) {
        Corners corners;
        if (((groups.wide >> (from / lanes)) & 1U) == 0)
            gatherNarrow(chunk.narrow.data() + from, corners);
        else
            gatherAny(chunk, from, corners);
        if (((groups.mixed >> (from / lanes)) & 1U) == 0)
            computeGroup(chunk, from, corners, headersOf(*chunk.header[from]), scale, answers + from);
        else
            computeGroup(chunk, from, corners, headersOf(chunk.header.data() + from), scale, answers + from);
    }
}

constexpr FineBrick noBrick{};
constexpr std::array<std::int8_t, PartFieldLayers::narrowStride> noResiduals{};

} // namespace

void PartFieldLayers::sample(std::span<const glm::dvec3> points, std::span<PartDistance> answers) const noexcept {
    const Frame frame{origin, voxelCount_, perVoxel_};
    Chunk chunk;
    std::array<std::uint32_t, chunkPoints> others; // what is not in a fine brick's trilinear cell
    std::array<glm::dvec3, chunkPoints> padded;
    std::array<PartDistance, chunkPoints> found;
    for (std::size_t first = 0; first < points.size(); first += chunkPoints) {
        const std::size_t count = std::min(chunkPoints, points.size() - first);
        const glm::dvec3* from = points.data() + first;
        PartDistance* to = answers.data() + first;
        if (count < chunkPoints) {
            std::copy_n(from, count, padded.begin());
            std::fill(padded.begin() + static_cast<std::ptrdiff_t>(count), padded.end(), from[0]);
            from = padded.data();
            to = found.data();
        }
        if (!placeAll(from, frame, chunk)) {
            for (std::size_t i = 0; i < count; ++i) answers[first + i] = sample(points[first + i]);
            continue;
        }
        std::size_t otherCount = 0;
        Groups groups;
        glm::ivec3 last(-1);
        const FineBrick* brick = nullptr;
        const std::int8_t* narrowSamples = nullptr;
        const std::int16_t* wideSamples = nullptr;
        for (std::size_t i = 0; i < chunkPoints; ++i) {
            const glm::ivec3 here(chunk.brick[0][i], chunk.brick[1][i], chunk.brick[2][i]);
            if (((here.x ^ last.x) | (here.y ^ last.y) | (here.z ^ last.z)) != 0) {
                last = here;
                if (i % lanes != 0) groups.mixed |= 1U << (i / lanes);
                brick = fineBrickAt(here << 3);
                if (brick != nullptr) {
                    const bool isWide = brick->wide != 0;
                    narrowSamples = isWide ? nullptr : narrow.data() + std::size_t{brick->samples} * narrowStride;
                    wideSamples = isWide ? wide.data() + std::size_t{brick->samples} * CellGrid::samples : nullptr;
                }
            }
            const std::int32_t sampleAt = chunk.first[i];
            if (brick == nullptr || (brick->exact != FineBrick::none && isExact(*brick, CellGrid::cellOf(sampleAt)))) {
                if (i < count) others[otherCount++] = static_cast<std::uint32_t>(i);
                chunk.header[i] = &noBrick;
                chunk.narrow[i] = noResiduals.data();
                groups.mixed |= 1U << (i / lanes);
                continue;
            }
            chunk.header[i] = brick;
            chunk.narrow[i] = narrowSamples != nullptr ? narrowSamples + sampleAt : nullptr;
            if (narrowSamples == nullptr) {
                chunk.wide[i] = wideSamples + sampleAt;
                groups.wide |= 1U << (i / lanes);
            }
        }
        computeAll(chunk, groups, static_cast<float>(perVoxel_), to);
        if (to == found.data()) std::copy_n(found.begin(), count, answers.begin() + static_cast<std::ptrdiff_t>(first));
        for (std::size_t i = 0; i < otherCount; ++i) answers[first + others[i]] = sample(points[first + others[i]]);
    }
}

} // namespace burin
