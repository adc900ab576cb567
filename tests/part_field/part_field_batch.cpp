// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/vectorised.h"
#include "tests/part_field/part_field_layers.h"
#include "tests/part_field/placed_points.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>

namespace burin {

namespace {

constexpr std::size_t chunkPoints = PlacedPoints::most;
/// The data of an interval are copied to this many points at once, as many as possible: most intervals have no more.
constexpr std::size_t overrun = 16;

/// Points as arrays: placed and computed eight at a time, looked up one by one in between.
struct Chunk : PlacedPoints {
    std::array<const FineBrick*, chunkPoints + overrun> header;
    std::array<const std::int8_t*, chunkPoints + overrun> narrow; ///< the brick's residuals, unless they are wide
    const std::int16_t* wide = nullptr;                           ///< those of all bricks
};

using TwoDoubles = double __attribute__((vector_size(16)));
using FourFloats = float __attribute__((vector_size(16)));

/// The eight corners of eight cells, x running fastest.
struct Corners {
    std::array<Floats, 8> of;
};

using Bytes = std::int8_t __attribute__((vector_size(32)));

/// The corners of a narrow cell, eight numbers of a byte: the first half of a register holds the lower four, repeated
/// in each word of it; the second half the upper four.
BURIN_INLINE Integers cellAt(const std::int8_t* first) noexcept {
    static_assert(7 * (1 + 9 + 81) + 81 + 16 <= PartFieldLayers::narrowStride); // bytes read for the last cell
    TwoDoubles low, high;                                                       // sixteen bytes each
    std::memcpy(&low, first, sizeof low);
    std::memcpy(&high, first + 81, sizeof high);
    const auto all = reinterpret_cast<Bytes>(__builtin_shufflevector(low, high, 0, 1, 2, 3));
    return reinterpret_cast<Integers>(__builtin_shufflevector(all, all, 0, 1, 9, 10, 0, 1, 9, 10, 0, 1, 9, 10, 0, 1, 9,
                                                              10, 16, 17, 25, 26, 16, 17, 25, 26, 16, 17, 25, 26, 16,
                                                              17, 25, 26));
}
/// For four cells: one word each for their lower corners, followed by one each for their upper corners.
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
        for (std::size_t i = 0; i < 4; ++i) // x86: the lowest byte comes first
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

/// Stores the answers lane by lane.
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
    for (std::size_t i = 0; i < 4; i += 2) { // row i contains lanes i and i + 4
        const Floats low = __builtin_shufflevector(rows[i], rows[i + 1], 0, 1, 2, 3, 8, 9, 10, 11);
        const Floats high = __builtin_shufflevector(rows[i], rows[i + 1], 4, 5, 6, 7, 12, 13, 14, 15);
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

/// A bit per group of eight.
static_assert(chunkPoints / lanes <= 32);
struct Groups {
    std::uint32_t wide = 0;  ///< some of its bricks have residuals of 16 bits
    std::uint32_t mixed = 0; ///< its points are in several bricks
};

BURIN_VECTORISED void computeAll(const Chunk& chunk, std::size_t count, const Groups& groups, float perVoxel,
                                 PartDistance* answers) noexcept {
    const Floats scale = floats(perVoxel);
    for (std::size_t from = 0; from < count; from += lanes) {
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

/// Consecutive points in one brick, up to where the next begins.
struct Interval {
    const FineBrick* header;
    const std::int8_t* narrow;
    std::size_t first;
};

/// Copies the data of each interval to its points. Values that a short interval writes too far are overwritten by the
/// next one.
/// @param intervals followed by one that begins where they end
BURIN_VECTORISED void spread(const Interval* intervals, std::size_t count, Chunk& chunk) noexcept {
    for (std::size_t n = 0; n < count; ++n) {
        const auto [header, narrow, begin] = intervals[n];
        const std::size_t end = intervals[n + 1].first;
        for (std::size_t first = begin; first < end; first += overrun) {
            std::fill_n(&chunk.header[first], overrun, header);
            std::fill_n(&chunk.narrow[first], overrun, narrow);
        }
    }
}

/// A group in which a brick begins has several bricks, unless the brick begins with the group.
std::uint32_t mixedGroups(const PlacedPoints& placed, std::size_t count) noexcept {
    std::uint32_t mixed = 0;
    for (std::size_t group = 0; group < count / lanes; ++group)
        mixed |= std::uint32_t{(placed.begins[group] & 0xfeU) != 0} << group;
    return mixed;
}

} // namespace

/// Answers queries for points of one field.
class PartFieldLayers::Batch {
public:
    explicit Batch(const PartFieldLayers& layers) noexcept
        : layers_(layers), frame_{layers.origin, layers.blocks * blockVoxels, layers.perVoxel_} {
        chunk_.wide = layers.wide.data();
    }

    void answer(std::span<const glm::dvec3> points, PartDistance* answers) noexcept {
        const std::size_t rest = points.size() % lanes, whole = points.size() - rest;
        for (std::size_t first = 0; first < whole; first += chunkPoints)
            answer(&points[first], std::min(chunkPoints, whole - first), answers + first);
        if (rest == 0) return;
        std::array<glm::dvec3, lanes> padded;
        std::array<PartDistance, lanes> found;
        padded.fill(points.back());
        std::ranges::copy(points.last(rest), padded.begin());
        answer(padded.data(), lanes, found.data());
        std::copy_n(found.begin(), rest, answers + whole);
    }

private:
    /// @param count a multiple of `lanes`, at most `chunkPoints`
    void answer(const glm::dvec3* points, std::size_t count, PartDistance* answers) noexcept {
        if (!placePoints(points, count, frame_, chunk_)) return answerApart(points, count, answers);
        groups_ = {0, mixedGroups(chunk_, count)};
        spread(intervals_.data(), findIntervals(count), chunk_);
        computeAll(chunk_, count, groups_, static_cast<float>(layers_.perVoxel_), answers);
        for (std::size_t i = 0; i < otherCount_; ++i) answers[others_[i]] = layers_.sample(points[others_[i]]);
    }

    /// Used if some points lie outside the layers' box: those and the points next to them are answered one by one.
    void answerApart(const glm::dvec3* points, std::size_t count, PartDistance* answers) noexcept {
        constexpr std::size_t fewer = 32;
        for (std::size_t first = 0; first < count; first += fewer) {
            const std::size_t some = std::min(fewer, count - first);
            if (count > fewer)
                answer(points + first, some, answers + first);
            else
                for (std::size_t i = 0; i < some; ++i) answers[i] = layers_.sample(points[i]);
        }
    }

    /// @return the number of intervals
    std::size_t findIntervals(std::size_t count) noexcept {
        std::size_t found = 0;
        for (std::size_t from = 0; from < count; from += 64) {
            std::uint64_t begins = 0;
            std::memcpy(&begins, &chunk_.begins[from / lanes], std::min<std::size_t>(count - from, 64) / lanes);
            for (; begins != 0; begins &= begins - 1) // x86: the lowest byte comes first
                intervals_[found++].first = from + static_cast<std::size_t>(std::countr_zero(begins));
        }
        intervals_[found].first = count;
        otherCount_ = 0;
        for (std::size_t i = 0; i < found; ++i) fillInterval(intervals_[i], intervals_[i + 1].first);
        return found;
    }

    /// Points that are not in a fine brick's trilinear cell are added to the others.
    void fillInterval(Interval& interval, std::size_t end) noexcept {
        const std::size_t first = interval.first;
        const glm::ivec3 at(chunk_.brick[0][first], chunk_.brick[1][first], chunk_.brick[2][first]);
        const FineBrick* const brick = layers_.fineBrickAt(at << 3);
        interval.header = brick == nullptr ? &noBrick : brick;
        interval.narrow = noResiduals.data();
        if (brick == nullptr || brick->exact != FineBrick::none)
            for (std::size_t i = first; i < end; ++i)
                if (brick == nullptr || layers_.isExact(*brick, CellGrid::cellOf(chunk_.first[i])))
                    others_[otherCount_++] = static_cast<std::uint8_t>(i);
        if (brick == nullptr) return;
        if (brick->wide == 0)
            interval.narrow = layers_.narrow.data() + std::size_t{brick->samples} * narrowStride;
        else
            for (std::size_t group = first / lanes; group * lanes < end; ++group) groups_.wide |= 1U << group;
    }

    const PartFieldLayers& layers_;
    FieldFrame frame_;
    Chunk chunk_;
    Groups groups_;
    std::array<Interval, chunkPoints + 1> intervals_;
    std::array<std::uint8_t, chunkPoints> others_; ///< in rising order
    std::size_t otherCount_ = 0;
};

void PartFieldLayers::sample(std::span<const glm::dvec3> points, std::span<PartDistance> answers) const noexcept {
    Batch(*this).answer(points, answers.data());
}

} // namespace burin
