// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/vectorised.h"
#include "core/field/part_field_layers.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>

namespace burin {

namespace {

constexpr std::size_t chunkPoints = 64;
/// So many points are handed what their stretch has, as many as it may have: mostly it has no more.
constexpr std::size_t overrun = 16;
template <class Number>
using Row = std::array<Number, chunkPoints>;

/// Points side by side: placed and computed eight at a time, looked up one by one in between.
struct Chunk {
    std::array<Row<float>, 3> share;                                ///< of the cell
    std::array<Row<float>, 3> along;                                ///< voxels from the brick's lowest corner
    std::array<std::array<std::int32_t, chunkPoints + 1>, 3> brick; ///< counted from the origin; point 0 in place 1
    Row<std::int32_t> first;                                        ///< of the cell's samples in the brick
    std::array<const FineBrick*, chunkPoints + overrun> header;
    std::array<const std::int8_t*, chunkPoints + overrun> narrow; ///< the brick's residuals, unless they are wide
    const std::int16_t* wide = nullptr;                           ///< those of all bricks
};

/// Where the layers lie, as registers want it: the coordinates that follow each other in points, from x on.
struct Frame {
    std::array<double, 6> origin;        ///< x y, z x, y z, mm
    double perVoxel;                     ///< 1/mm
    std::array<std::uint32_t, 3> voxels; ///< along each axis

    Frame(const glm::dvec3& low, const glm::ivec3& count, double scale) noexcept
        : origin{low.x, low.y, low.z, low.x, low.y, low.z}, perVoxel(scale) {
        for (int axis = 0; axis < 3; ++axis)
            voxels[static_cast<std::size_t>(axis)] = std::min(static_cast<std::uint32_t>(count[axis]), mostVoxels);
    }
    static constexpr std::uint32_t mostVoxels = 1U << 19; ///< of more, placing knows only the first
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

/// A number of voxels in fixed point: a double that is added to it keeps 32 bits behind the point, in the lower word,
/// and the whole voxels above it, in the upper. Off by 2^-33 voxel at most, so that a place so near to the border of a
/// cell may count for either; values are the same from both sides.
constexpr double fixedPoint = 1.5 * (1 << 20);
constexpr std::uint32_t fixedPointUpper = 0x41380000;

/// One word each of eight coordinates, by axis.
using PerAxis = std::array<Words, 3>;

/// @param at lower words x0 y0 z0 x1, y1 z1 x2 y2, z2 x3 y3 z3 of points 0 … 3, upper ones likewise of 4 … 7
BURIN_INLINE PerAxis byAxis(const PerAxis& at) noexcept {
    const Words xy = __builtin_shufflevector(at[1], at[2], 2, 3, 9, 10, 6, 7, 13, 14);
    const Words yz = __builtin_shufflevector(at[0], at[1], 1, 2, 8, 9, 5, 6, 12, 13);
    return {__builtin_shufflevector(at[0], xy, 0, 3, 8, 10, 4, 7, 12, 14),
            __builtin_shufflevector(yz, xy, 0, 2, 9, 11, 4, 6, 13, 15),
            __builtin_shufflevector(yz, at[2], 1, 3, 8, 11, 5, 7, 12, 15)};
}

/// Places of eight points in fixed point.
struct FixedPlaces {
    PerAxis voxel, share; ///< of a place beside the layers' low side, or that is no number, a huge voxel
};
BURIN_INLINE FixedPlaces fixedPlaces(const double* points, const Frame& frame) noexcept {
    PerAxis lower, upper;
    const auto placed = [&](std::size_t from, std::size_t axis) noexcept {
        const FourDoubles origin = pairs(&frame.origin[axis], &frame.origin[axis]);
        return reinterpret_cast<Words>((pairs(points + from, points + 12 + from) - origin) * frame.perVoxel +
                                       fixedPoint);
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const Words one = placed(4 * i, 4 * i % 6), next = placed(4 * i + 2, (4 * i + 2) % 6);
        lower[i] = __builtin_shufflevector(one, next, 0, 2, 8, 10, 4, 6, 12, 14);
        upper[i] = __builtin_shufflevector(one, next, 1, 3, 9, 11, 5, 7, 13, 15) - fixedPointUpper;
    }
    return {byAxis(upper), byAxis(lower)};
}

template <class Lanes>
BURIN_INLINE void store(const Lanes& values, void* to) noexcept {
    std::memcpy(to, &values, sizeof values);
}

/// @return whether all of them are in the box of the layers; if not, the chunk is of no use
BURIN_VECTORISED_TO_AVX512 bool placeAll(const glm::dvec3* points, const Frame& where, Chunk& chunk) noexcept {
    static_assert(sizeof(glm::dvec3) == 3 * sizeof(double));
    const Frame frame = where; // which what is written to the chunk can't change: it stays in registers
    PerAxis highest{};
    for (std::size_t from = 0; from < chunkPoints; from += lanes) {
        const FixedPlaces places = fixedPlaces(&points[from].x, frame);
        Integers first{};
        for (std::size_t axis = 3; axis-- > 0;) {
            const Words voxel = places.voxel[axis];
            highest[axis] = voxel > highest[axis] ? voxel : highest[axis];
            const auto cell = reinterpret_cast<Integers>(voxel & (CellGrid::cells - 1));
            const Floats share = floatsOf(reinterpret_cast<Integers>(places.share[axis] >> 8)) * 0x1p-24F;
            store(share, chunk.share[axis].data() + from);
            store(floatsOf(cell) + share, chunk.along[axis].data() + from);
            store(voxel >> 3, chunk.brick[axis].data() + 1 + from);
            first = CellGrid::along * first + cell;
        }
        store(first, chunk.first.data() + from);
    }
    auto outside = highest[0] >= frame.voxels[0];
    for (std::size_t axis = 1; axis < 3; ++axis) outside |= highest[axis] >= frame.voxels[axis];
    return !anyOf(outside);
}

/// A bit for each point that lies in another brick than the one before; the first always has one.
BURIN_VECTORISED_TO_AVX512 std::uint64_t brickBegins(const Chunk& chunk) noexcept {
    std::uint64_t begins = 0;
    for (std::size_t from = 0; from < chunkPoints; from += lanes) {
        Integers unlike{};
        for (const auto& places : chunk.brick) {
            Integers before, here;
            std::memcpy(&before, places.data() + from, sizeof before);
            std::memcpy(&here, places.data() + 1 + from, sizeof here);
            unlike |= before ^ here;
        }
        begins |= std::uint64_t{bitsOf(unlike != Integers{})} << from;
    }
    return begins | 1U;
}

/// The eight corners of a cell, x running fastest, of eight cells.
struct Corners {
    std::array<Floats, 8> of;
};

using Bytes = std::int8_t __attribute__((vector_size(32)));

/// The corners of a narrow cell, eight numbers of a byte: in the first half of a register the lower four, in each word
/// of it the same; in the second half the upper four.
BURIN_INLINE Integers cellAt(const std::int8_t* first) noexcept {
    static_assert(7 * (1 + 9 + 81) + 81 + 16 <= PartFieldLayers::narrowStride); // what is read of the last cell
    TwoDoubles low, high;                                                       // sixteen bytes each
    std::memcpy(&low, first, sizeof low);
    std::memcpy(&high, first + 81, sizeof high);
    const auto all = reinterpret_cast<Bytes>(__builtin_shufflevector(low, high, 0, 1, 2, 3));
    return reinterpret_cast<Integers>(__builtin_shufflevector(all, all, 0, 1, 9, 10, 0, 1, 9, 10, 0, 1, 9, 10, 0, 1, 9,
                                                              10, 16, 17, 25, 26, 16, 17, 25, 26, 16, 17, 25, 26, 16,
                                                              17, 25, 26));
}
/// Of four cells: a word each for their lower corners, and behind these for their upper ones.
BURIN_INLINE Integers fourCells(const Chunk& chunk, std::size_t from) noexcept {
    const auto cell = [&](std::size_t i) noexcept { return cellAt(chunk.narrow[from + i] + chunk.first[from + i]); };
    const Integers ab = __builtin_shufflevector(cell(0), cell(1), 0, 9, 2, 11, 4, 13, 6, 15);
    const Integers cd = __builtin_shufflevector(cell(2), cell(3), 0, 9, 2, 11, 4, 13, 6, 15);
    return __builtin_shufflevector(ab, cd, 0, 1, 10, 11, 4, 5, 14, 15);
}
BURIN_INLINE void gatherNarrow(const Chunk& chunk, std::size_t from, Corners& corners) noexcept {
    const Integers one = fourCells(chunk, from), other = fourCells(chunk, from + 4);
    const std::array<Integers, 2> layers{__builtin_shufflevector(one, other, 0, 1, 2, 3, 8, 9, 10, 11),
                                         __builtin_shufflevector(one, other, 4, 5, 6, 7, 12, 13, 14, 15)};
    for (std::size_t layer = 0; layer < 2; ++layer)
        for (std::size_t i = 0; i < 4; ++i) // x86: the lowest byte is the first
            corners.of[4 * layer + i] = floatsOf(layers[layer] << static_cast<int>(24 - 8 * i) >> 24);
}
BURIN_INLINE void gatherAny(const Chunk& chunk, std::size_t from, Corners& corners) noexcept {
    constexpr std::array<int, 8> steps{0, 1, 9, 10, 81, 82, 90, 91};
    std::array<EightIntegers, 8> found;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        const auto take = [&](const auto* first) {
            for (std::size_t i = 0; i < 8; ++i) found[i][static_cast<int>(lane)] = first[steps[i]];
        };
        const FineBrick& brick = *chunk.header[from + lane];
        if (brick.wide == 0)
            take(chunk.narrow[from + lane] + chunk.first[from + lane]);
        else
            take(chunk.wide + std::size_t{brick.samples} * CellGrid::samples + chunk.first[from + lane]);
    }
    for (std::size_t i = 0; i < 8; ++i) corners.of[i] = floatsOf(load(found[i]));
}

/// Headers of the bricks of eight cells.
struct Headers {
    Floats base, quantum;
    std::array<Floats, 3> slope;
};
BURIN_INLINE FourFloats fourOf(const float* first) noexcept {
    FourFloats values;
    std::memcpy(&values, first, sizeof values);
    return values;
}
/// Four numbers each of headers i and i + 4.
BURIN_INLINE Floats pairOf(const FineBrick* const* header, std::size_t i) noexcept {
    return __builtin_shufflevector(fourOf(&header[i]->base), fourOf(&header[i + 4]->base), 0, 1, 2, 3, 4, 5, 6, 7);
}
BURIN_INLINE Headers headersOf(const FineBrick* const* header) noexcept {
    static_assert(offsetof(FineBrick, slope) == offsetof(FineBrick, base) + sizeof(float));
    const Floats a = pairOf(header, 0), b = pairOf(header, 1), c = pairOf(header, 2), d = pairOf(header, 3);
    const Floats low0 = __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
    const Floats low1 = __builtin_shufflevector(c, d, 0, 8, 1, 9, 4, 12, 5, 13);
    const Floats high0 = __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
    const Floats high1 = __builtin_shufflevector(c, d, 2, 10, 3, 11, 6, 14, 7, 15);
    return {__builtin_shufflevector(low0, low1, 0, 1, 8, 9, 4, 5, 12, 13),
            Floats{header[0]->quantum, header[1]->quantum, header[2]->quantum, header[3]->quantum, header[4]->quantum,
                   header[5]->quantum, header[6]->quantum, header[7]->quantum},
            {__builtin_shufflevector(low0, low1, 2, 3, 10, 11, 6, 7, 14, 15),
             __builtin_shufflevector(high0, high1, 0, 1, 8, 9, 4, 5, 12, 13),
             __builtin_shufflevector(high0, high1, 2, 3, 10, 11, 6, 7, 14, 15)}};
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
            gatherNarrow(chunk, from, corners);
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

/// Points one after the other in one brick, up to where the next begins.
struct Stretch {
    const FineBrick* header = &noBrick;
    const std::int8_t* narrow = noResiduals.data();
    std::size_t first = 0;
};

/// Hands each point what its stretch has. What a short stretch writes too far, the next writes over.
BURIN_VECTORISED void spread(const Stretch* stretches, std::size_t count, Chunk& chunk) noexcept {
    for (std::size_t n = 0; n < count; ++n) {
        const auto [header, narrow, begin] = stretches[n];
        const std::size_t end = n + 1 < count ? stretches[n + 1].first : chunkPoints;
        for (std::size_t first = begin; first < end; first += overrun) {
            std::fill_n(&chunk.header[first], overrun, header);
            std::fill_n(&chunk.narrow[first], overrun, narrow);
        }
    }
}

/// A group that a brick begins in lies in several, unless it begins with the group.
std::uint32_t mixedGroups(std::uint64_t begins) noexcept {
    std::uint32_t mixed = 0;
    for (std::size_t group = 0; group < chunkPoints / lanes; ++group)
        mixed |= std::uint32_t{(begins >> (group * lanes) & 0xfeU) != 0} << group;
    return mixed;
}

} // namespace

/// Answers points of one field, up to `chunkPoints` at a time.
class PartFieldLayers::Batch {
public:
    explicit Batch(const PartFieldLayers& layers) noexcept
        : layers_(layers), frame_{layers.origin, layers.blocks * blockVoxels, layers.perVoxel_} {
        chunk_.wide = layers.wide.data();
        for (auto& places : chunk_.brick) places[0] = -1;
    }

    void answer(std::span<const glm::dvec3> points, PartDistance* answers) noexcept {
        if (points.size() == chunkPoints) return answer(points.data(), chunkPoints, answers);
        std::array<glm::dvec3, chunkPoints> padded;
        std::array<PartDistance, chunkPoints> found;
        const auto rest = std::ranges::copy(points, padded.begin()).out;
        std::fill(rest, padded.end(), points.front());
        answer(padded.data(), points.size(), found.data());
        std::copy_n(found.begin(), points.size(), answers);
    }

private:
    /// @param points, answers so many as a chunk has; `count` of them matter
    void answer(const glm::dvec3* points, std::size_t count, PartDistance* answers) noexcept {
        if (!placeAll(points, frame_, chunk_)) {
            for (std::size_t i = 0; i < count; ++i) answers[i] = layers_.sample(points[i]);
            return;
        }
        const std::uint64_t begins = brickBegins(chunk_);
        groups_ = {0, mixedGroups(begins)};
        spread(stretches_.data(), findStretches(begins), chunk_);
        computeAll(chunk_, groups_, static_cast<float>(layers_.perVoxel_), answers);
        for (std::size_t i = 0; i < otherCount_ && others_[i] < count; ++i)
            answers[others_[i]] = layers_.sample(points[others_[i]]);
    }

    /// @return how many there are
    std::size_t findStretches(std::uint64_t begins) noexcept {
        otherCount_ = 0;
        std::size_t found = 0;
        for (; begins != 0; ++found) {
            const auto first = static_cast<std::size_t>(std::countr_zero(begins));
            begins &= begins - 1;
            const std::size_t end = begins == 0 ? chunkPoints : static_cast<std::size_t>(std::countr_zero(begins));
            const glm::ivec3 at(chunk_.brick[0][first + 1], chunk_.brick[1][first + 1], chunk_.brick[2][first + 1]);
            stretches_[found] = stretchIn(layers_.fineBrickAt(at << 3), first, end);
        }
        return found;
    }

    /// A stretch of points; what is not in a fine brick's trilinear cell is put with the others.
    Stretch stretchIn(const FineBrick* brick, std::size_t first, std::size_t end) noexcept {
        if (brick == nullptr || brick->exact != FineBrick::none)
            for (std::size_t i = first; i < end; ++i)
                if (brick == nullptr || layers_.isExact(*brick, CellGrid::cellOf(chunk_.first[i])))
                    others_[otherCount_++] = static_cast<std::uint8_t>(i);
        if (brick == nullptr) return {&noBrick, noResiduals.data(), first};
        if (brick->wide == 0) return {brick, layers_.narrow.data() + std::size_t{brick->samples} * narrowStride, first};
        for (std::size_t group = first / lanes; group * lanes < end; ++group) groups_.wide |= 1U << group;
        return {brick, noResiduals.data(), first};
    }

    const PartFieldLayers& layers_;
    Frame frame_;
    Chunk chunk_;
    Groups groups_;
    std::array<Stretch, chunkPoints> stretches_;
    std::array<std::uint8_t, chunkPoints> others_; ///< in rising order
    std::size_t otherCount_ = 0;
};

void PartFieldLayers::sample(std::span<const glm::dvec3> points, std::span<PartDistance> answers) const noexcept {
    Batch batch(*this);
    for (std::size_t first = 0; first < points.size(); first += chunkPoints)
        batch.answer(points.subspan(first, std::min(chunkPoints, points.size() - first)), answers.data() + first);
}

} // namespace burin
