// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/boolean.h"

#include "core/volume/runs/alike_merge.h"
#include "core/volume/runs/assembly.h"
#include "core/volume/runs/brick_merge.h"
#include "core/volume/runs/intervals.h"
#include "core/volume/runs/volume_access.h"

#include <array>
#include <cstring>
#include <new>
#include <numeric>
#include <optional>

namespace burin {

namespace {

/// Index of each property of an operand in the result's list.
using Places = std::array<PropertyIndex, 256>;

std::optional<PropertyIndex> placeOf(const PropertyList& list, const std::string& id) {
    for (int k = 0; k < list.size(); ++k)
        if (list[static_cast<PropertyIndex>(k)].id == id) return static_cast<PropertyIndex>(k);
    return std::nullopt;
}

/// Adds the missing properties to `list`.
Result<void> unite(PropertyList& list, const PropertyList& other) {
    for (int i = 1; i < other.size(); ++i) {
        const Property& property = other[static_cast<PropertyIndex>(i)];
        if (placeOf(list, property.id)) continue;
        if (Result<PropertyIndex> added = list.add(property); !added) return added.error();
    }
    return {};
}

Result<Places> placesIn(const PropertyList& list, const PropertyList& other) {
    Places places{};
    for (int i = 1; i < other.size(); ++i) {
        const std::string& id = other[static_cast<PropertyIndex>(i)].id;
        const std::optional<PropertyIndex> place = placeOf(list, id);
        if (!place) return Error{ErrorCode::argumentInvalid, "property", id, "a property of the result"};
        places[static_cast<std::size_t>(i)] = *place;
    }
    return places;
}

Places unchanged() {
    Places places{};
    std::iota(places.begin(), places.end(), PropertyIndex{0});
    return places;
}

bool keepsPlaces(const Places& places, const PropertyList& list) {
    for (int i = 0; i < list.size(); ++i)
        if (places[static_cast<std::size_t>(i)] != i) return false;
    return true;
}

// The result of an operation at one position, from both operands' segments there (BrickMerge).
constexpr std::uint32_t propertyBits = 0xff;
struct Union {
    static constexpr std::uint32_t pick(std::uint32_t a, std::uint32_t b) { return (a & propertyBits) == 0 ? b : a; }
};
struct Intersection {
    static constexpr std::uint32_t pick(std::uint32_t a, std::uint32_t b) {
        return a & ((b & propertyBits) == 0 ? ~propertyBits : ~0U);
    }
};
struct Difference {
    static constexpr std::uint32_t pick(std::uint32_t a, std::uint32_t b) {
        return a & ((b & propertyBits) == 0 ? ~0U : ~propertyBits);
    }
};
/// Whether the operation keeps material that only A, only B, or both have.
template <class Operation>
constexpr bool keepsA = Operation::pick(1, 0) != 0;
template <class Operation>
constexpr bool keepsB = Operation::pick(0, 1) != 0;
template <class Operation>
constexpr bool keepsBoth = Operation::pick(1, 1) != 0;

/// One operand: its bricks, and the mapping of its properties to those of the result.
class Operand {
public:
    Operand(const VolumeSnapshot& snapshot, const Places& places)
        : state_(VolumeAccess::state(snapshot)), places_(places), same_(keepsPlaces(places, snapshot.properties())) {}

    BlockIndex blockAt(std::int32_t brickU, std::int32_t brickV) const noexcept {
        return VolumeAccess::tileAt(state_, brickU, brickV);
    }
    Tile tile(BlockIndex block) const noexcept { return state_.store->tile(block); }
    /// The brick's segments with the result's properties: the originals, or copies in `room`.
    const Segment* segments(const Tile& tile, std::vector<Segment>& room) const {
        if (same_) return tile.segments();
        room.resize(tile.segmentCount());
        write(tile, room.data());
        return room.data();
    }

    /// Whether every line is air from end to end.
    bool isAir(const Tile& tile) const noexcept {
        return tile.segmentCount() == linesPerTile && every(tile, [](PropertyIndex p) { return p == airProperty; });
    }
    /// Whether every line is material of one property from end to end.
    bool isSolid(const Tile& tile) const noexcept {
        return tile.segmentCount() == linesPerTile && every(tile, [](PropertyIndex p) { return p != airProperty; });
    }
    void copy(const Tile& tile, BrickLines& lines) const {
        lines.writeAll(tile.segmentCount(), [&](Segment* segments, std::uint32_t* offsets) {
            for (int line = 0; line <= linesPerTile; ++line) offsets[line] = tile.offset(line);
            write(tile, segments);
        });
    }

private:
    void write(const Tile& tile, Segment* segments) const noexcept {
        const Segment* const from = tile.segments();
        const std::uint32_t count = tile.segmentCount();
        if (same_)
            std::memcpy(segments, from, count * sizeof(Segment));
        else
            for (std::uint32_t i = 0; i < count; ++i) segments[i] = Segment(from[i].end(), places_[from[i].property()]);
    }
    template <class Test>
    static bool every(const Tile& tile, Test test) noexcept {
        bool all = test(tile.segments()[0].property());
        for (int i = 1; i < linesPerTile && all; ++i) all = test(tile.segments()[i].property());
        return all;
    }

    const VolumeState& state_;
    Places places_;
    bool same_;
};

/// Makes the bricks of the result one after the other.
template <class Operation>
class Combination {
public:
    Combination(const Operand& a, const Operand& b, RunPosition lineEnd)
        : a_(a), b_(b), lineEnd_(lineEnd), air_(lineEnd), lines_(lineEnd) {
        air_.endLine();
        air_.repeatFirst();
    }

    const BrickLines& at(std::int32_t brickU, std::int32_t brickV) {
        const BlockIndex blockA = a_.blockAt(brickU, brickV), blockB = b_.blockAt(brickU, brickV);
        // Bricks with equal content share one block; in stock and air many neighbours do.
        if (blockA == blockA_ && blockB == blockB_) return *present_;
        blockA_ = blockA;
        blockB_ = blockB;
        const Tile tileA = a_.tile(blockA), tileB = b_.tile(blockB);
        const bool airA = a_.isAir(tileA), airB = b_.isAir(tileB);
        present_ = &lines_;
        using Op = Operation;
        if ((airA && (airB || !keepsB<Op>)) || (airB && !keepsA<Op>) || (!keepsBoth<Op> && b_.isSolid(tileB)))
            present_ = &air_;
        else if (airA)
            b_.copy(tileB, lines_);
        else if (airB || (keepsB<Op> && a_.isSolid(tileA)) || (keepsBoth<Op> && !keepsB<Op> && b_.isSolid(tileB)))
            a_.copy(tileA, lines_);
        else
            merge(tileA, tileB);
        return *present_;
    }

private:
    void merge(const Tile& tileA, const Tile& tileB) {
        const Segment *const a = a_.segments(tileA, roomA_), *const b = b_.segments(tileB, roomB_);
        lines_.writeAll(tileA.segmentCount() + tileB.segmentCount() + spare,
                        [&](Segment* segments, std::uint32_t* offsets) {
                            if (!mergeAlike(a, b, tileA, tileB, segments, offsets))
                                BrickMerge<Operation>::run(a, b, tileA, tileB, lineEnd_, segments, offsets);
                        });
    }
#ifdef BURIN_AVX512
    static constexpr std::size_t spare = AlikeMerge<Operation>::spare;
    template <class... Arguments>
    bool mergeAlike(Arguments... arguments) {
        return hasAvx512 && alike_.run(arguments...);
    }
    AlikeMerge<Operation> alike_;
#else
    static constexpr std::size_t spare = 0;
    template <class... Arguments>
    bool mergeAlike(Arguments...) {
        return false;
    }
#endif

    const Operand &a_, &b_;
    RunPosition lineEnd_;
    BlockIndex blockA_ = noBlock, blockB_ = noBlock;
    BrickLines air_, lines_;
    const BrickLines* present_ = nullptr;
    std::vector<Segment> roomA_, roomB_;
};

Error gridsDiffer() {
    return {ErrorCode::argumentInvalid, "grid of the second volume", {}, "the grid of the first"};
}

/// Calls `work(describe)` with the function that makes the rows of bricks of the result.
template <class Operation, class Work>
auto withRows(const PropertyList& properties, const VolumeSnapshot& a, const VolumeSnapshot& b, Work work)
    -> decltype(work(std::function<void(std::int32_t, BrickSink&)>())) {
    const Result<Places> placesA = placesIn(properties, a.properties()), placesB = placesIn(properties, b.properties());
    if (!placesA) return placesA.error();
    // The properties of B matter only in a union; otherwise only whether they are air.
    if (keepsB<Operation> && !placesB) return placesB.error();
    const Operand operandA(a, *placesA), operandB(b, keepsB<Operation> ? *placesB : unchanged());
    const Grid& grid = a.grid();
    return work([&](std::int32_t row, BrickSink& sink) {
        Combination<Operation> combination(operandA, operandB, grid.lineEnd());
        for (LineIndex low{0, row * tileSide}; low.u < grid.lineCountU(); low.u += tileSide)
            sink.put(low, combination.at(low.u / tileSide, row));
    });
}

template <class Operation>
Result<RunVolume> combined(const VolumeSnapshot& a, const VolumeSnapshot& b, const PropertyList& properties) {
    if (!sameGrid(a.grid(), b.grid())) return gridsDiffer();
    return withRows<Operation>(properties, a, b,
                               [&](const auto& describe) { return assembleBricks(a.grid(), properties, describe); });
}

template <class Operation>
Result<void> combineInto(RunVolume& result, const VolumeSnapshot& a, const VolumeSnapshot& b) {
    if (!sameGrid(a.grid(), b.grid()) || !sameGrid(a.grid(), result.grid())) return gridsDiffer();
    return withRows<Operation>(result.properties(), a, b, [&](const auto& describe) -> Result<void> {
        try {
            if (result.rewriteBricks(describe)) return {};
            return Error{ErrorCode::volumeOutOfMemory, std::to_string(result.reservedBytes()), {}, {}};
        } catch (const std::bad_alloc&) {
            return Error{ErrorCode::outOfMemory, "volume", {}, {}};
        }
    });
}

} // namespace

Result<RunVolume> unionOf(const VolumeSnapshot& a, const VolumeSnapshot& b) {
    PropertyList properties = a.properties();
    if (Result<void> united = unite(properties, b.properties()); !united) return united.error();
    return combined<Union>(a, b, properties);
}
Result<RunVolume> intersectionOf(const VolumeSnapshot& a, const VolumeSnapshot& b) {
    return combined<Intersection>(a, b, a.properties());
}
Result<RunVolume> differenceOf(const VolumeSnapshot& a, const VolumeSnapshot& b) {
    return combined<Difference>(a, b, a.properties());
}

Result<void> uniteInto(RunVolume& result, const VolumeSnapshot& a, const VolumeSnapshot& b) {
    return combineInto<Union>(result, a, b);
}
Result<void> intersectInto(RunVolume& result, const VolumeSnapshot& a, const VolumeSnapshot& b) {
    return combineInto<Intersection>(result, a, b);
}
Result<void> subtractInto(RunVolume& result, const VolumeSnapshot& a, const VolumeSnapshot& b) {
    return combineInto<Difference>(result, a, b);
}

} // namespace burin
