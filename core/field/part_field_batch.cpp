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
template <class Number>
using Row = std::array<Number, chunkPoints>;

/// Points side by side: placed and computed eight at a time, looked up one by one in between.
struct Chunk {
    std::array<Row<float>, 3> share;                                ///< of the cell
    std::array<Row<float>, 3> along;                                ///< voxels from the brick's lowest corner
    std::array<std::array<std::int32_t, chunkPoints + 1>, 3> brick; ///< counted from the origin; point 0 in place 1
    Row<std::int32_t> first;                                        ///< of the cell's samples in the brick
    Row<const FineBrick*> header;
    Row<const std::int8_t*> narrow; ///< residuals at the cell's lowest corner; of no meaning in a brick of wide ones
    const std::int16_t* wide = nullptr; ///< those of all bricks
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
            store(voxel >> 3, chunk.brick[a].data() + 1 + from);
            first = CellGrid::along * first + cell;
        }
        store(first, chunk.first.data() + from);
    }
    return (inside[0] & inside[1] & inside[2] & inside[3]) != 0;
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
BURIN_INLINE Integers fourCells(const std::int8_t* const* first) noexcept {
    const Integers ab = __builtin_shufflevector(cellAt(first[0]), cellAt(first[1]), 0, 9, 2, 11, 4, 13, 6, 15);
    const Integers cd = __builtin_shufflevector(cellAt(first[2]), cellAt(first[3]), 0, 9, 2, 11, 4, 13, 6, 15);
    return __builtin_shufflevector(ab, cd, 0, 1, 10, 11, 4, 5, 14, 15);
}
BURIN_INLINE void gatherNarrow(const std::int8_t* const* first, Corners& corners) noexcept {
    const Integers one = fourCells(first), other = fourCells(first + 4);
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
            take(chunk.narrow[from + lane]);
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
        : layers_(layers), frame_{layers.origin, layers.voxelCount_, layers.perVoxel_} {
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
    /// Points one after the other in one brick.
    struct Stretch {
        const FineBrick* header = &noBrick;
        const std::int8_t* narrow = noResiduals.data();
    };

    /// @param points, answers so many as a chunk has; `count` of them matter
    void answer(const glm::dvec3* points, std::size_t count, PartDistance* answers) noexcept {
        if (!placeAll(points, frame_, chunk_)) {
            for (std::size_t i = 0; i < count; ++i) answers[i] = layers_.sample(points[i]);
            return;
        }
        const std::uint64_t begins = brickBegins(chunk_);
        groups_ = {0, mixedGroups(begins)};
        findStretches(begins);
        spread(begins);
        computeAll(chunk_, groups_, static_cast<float>(layers_.perVoxel_), answers);
        for (std::size_t i = 0; i < otherCount_ && others_[i] < count; ++i)
            answers[others_[i]] = layers_.sample(points[others_[i]]);
    }

    void findStretches(std::uint64_t begins) noexcept {
        otherCount_ = 0;
        std::size_t found = 0;
        for (; begins != 0; ++found) {
            const auto first = static_cast<std::size_t>(std::countr_zero(begins));
            begins &= begins - 1;
            const std::size_t end = begins == 0 ? chunkPoints : static_cast<std::size_t>(std::countr_zero(begins));
            const glm::ivec3 at(chunk_.brick[0][first + 1], chunk_.brick[1][first + 1], chunk_.brick[2][first + 1]);
            stretches_[found] = stretchIn(layers_.fineBrickAt(at << 3), first, end);
        }
    }

    /// A stretch of points; what is not in a fine brick's trilinear cell is put with the others.
    Stretch stretchIn(const FineBrick* brick, std::size_t first, std::size_t end) noexcept {
        if (brick == nullptr || brick->exact != FineBrick::none)
            for (std::size_t i = first; i < end; ++i)
                if (brick == nullptr || layers_.isExact(*brick, CellGrid::cellOf(chunk_.first[i])))
                    others_[otherCount_++] = static_cast<std::uint8_t>(i);
        if (brick == nullptr) return {};
        if (brick->wide == 0) return {brick, layers_.narrow.data() + std::size_t{brick->samples} * narrowStride};
        for (std::size_t group = first / lanes; group * lanes < end; ++group) groups_.wide |= 1U << group;
        return {brick, noResiduals.data()};
    }

    /// Hands each point what its stretch has, without a branch that depends on the points.
    void spread(std::uint64_t begins) noexcept {
        std::size_t begun = 0;
        for (std::size_t i = 0; i < chunkPoints; ++i, begins >>= 1) {
            begun += begins & 1U;
            const Stretch& stretch = stretches_[begun - 1];
            chunk_.header[i] = stretch.header;
            chunk_.narrow[i] = stretch.narrow + chunk_.first[i];
        }
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
