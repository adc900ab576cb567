// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/relation.h"

#include "core/base/parallel.h"
#include "core/volume/runs/intervals.h"
#include "core/volume/runs/volume_access.h"

#include <atomic>
#include <utility>

namespace burin {

namespace {

struct Contact {
    bool overlap = false, touch = false;
};

Contact contactOf(const std::vector<Interval>& a, const std::vector<Interval>& b) {
    Contact contact;
    for (std::size_t i = 0, k = 0; i < a.size() && k < b.size();) {
        const std::int64_t from = std::max(a[i].from, b[k].from), to = std::min(a[i].to, b[k].to);
        contact.overlap |= from < to;
        contact.touch |= from <= to;
        if (a[i].to < b[k].to)
            ++i;
        else
            ++k;
    }
    return contact;
}

void intervalsOf(std::span<const Segment> line, PropertyIndex property, std::vector<Interval>& intervals) {
    intervals.clear();
    RunPosition start = 0;
    for (const Segment segment : line) {
        if (segment.property() == property) intervals.push_back({start, segment.end()});
        start = segment.end();
    }
}

/// By brick of 8 × 8 scanlines: whether any property in it passes a test.
template <class Test>
std::vector<std::uint8_t> bricksThatHold(const VolumeSnapshot& volume, Test test) {
    const VolumeState& state = VolumeAccess::state(volume);
    const std::int32_t bricksU = state.store->table.tilesU, bricksV = state.store->table.tilesV;
    std::vector<std::uint8_t> holds(static_cast<std::size_t>(bricksU) * static_cast<std::size_t>(bricksV));
    parallelFor(std::int32_t{0}, bricksV, [&](std::int32_t v) {
        for (std::int32_t u = 0; u < bricksU; ++u) {
            const Tile tile = state.store->tile(VolumeAccess::tileAt(state, u, v));
            const std::span<const Segment> segments{tile.segments(), tile.segmentCount()};
            holds[static_cast<std::size_t>(v * bricksU + u)] =
                std::ranges::any_of(segments, [&](Segment segment) { return test(segment.property()); }) ? 1 : 0;
        }
    });
    return holds;
}

/// Compares bricks of one object that have the other object within one brick.
class Comparison {
public:
    Comparison(const Grid& grid, std::vector<std::uint8_t> holdsA, std::vector<std::uint8_t> holdsB)
        : grid_(grid), holdsA_(std::move(holdsA)), holdsB_(std::move(holdsB)) {}

    /// @param readA, readB  get the intervals of a line
    /// @param mayIntersect  false: the search ends as soon as they are found to touch
    template <class ReadA, class ReadB>
    SpatialRelation run(bool mayIntersect, ReadA readA, ReadB readB) {
        std::atomic<bool> intersecting{false}, adjacent{false};
        const auto known = [&] { return intersecting || (adjacent && !mayIntersect); };
        parallelFor(std::int32_t{0}, bricks(grid_.lineCountV()), [&](std::int32_t brickV) {
            std::vector<Interval> a, b;
            for (std::int32_t brickU = 0; brickU < bricks(grid_.lineCountU()); ++brickU) {
                if (known()) return;
                if (!holds(holdsA_, brickU, brickV) || !holdsNear(brickU, brickV)) continue;
                for (std::int32_t line = 0; line < linesPerTile && !known(); ++line) {
                    const LineIndex index{brickU * tileSide + line % tileSide, brickV * tileSide + line / tileSide};
                    if (!grid_.contains(index)) continue;
                    readA(index, a);
                    if (a.empty()) continue;
                    eachAround(index, [&](LineIndex near) {
                        readB(near, b);
                        const Contact contact = contactOf(a, b);
                        if (contact.overlap && near == index) intersecting = true;
                        if (contact.touch) adjacent = true;
                    });
                }
            }
        });
        return intersecting ? SpatialRelation::intersecting
               : adjacent   ? SpatialRelation::adjacent
                            : SpatialRelation::separate;
    }

private:
    static std::int32_t bricks(std::int32_t lines) { return (lines + tileSide - 1) / tileSide; }
    bool holds(const std::vector<std::uint8_t>& which, std::int32_t brickU, std::int32_t brickV) const {
        const std::int32_t bricksU = bricks(grid_.lineCountU()), bricksV = bricks(grid_.lineCountV());
        return brickU >= 0 && brickV >= 0 && brickU < bricksU && brickV < bricksV &&
               which[static_cast<std::size_t>(brickV * bricksU + brickU)] != 0;
    }
    bool holdsNear(std::int32_t brickU, std::int32_t brickV) const {
        for (std::int32_t v = brickV - 1; v <= brickV + 1; ++v)
            for (std::int32_t u = brickU - 1; u <= brickU + 1; ++u)
                if (holds(holdsB_, u, v)) return true;
        return false;
    }
    /// The line itself and its neighbours.
    template <class Visit>
    void eachAround(LineIndex line, Visit visit) const {
        for (std::int32_t v = line.v - 1; v <= line.v + 1; ++v)
            for (std::int32_t u = line.u - 1; u <= line.u + 1; ++u)
                if (grid_.contains(LineIndex{u, v})) visit(LineIndex{u, v});
    }

    const Grid& grid_;
    std::vector<std::uint8_t> holdsA_, holdsB_;
};

} // namespace

Result<SpatialRelation> relation(const VolumeSnapshot& a, const VolumeSnapshot& b) {
    if (!sameGrid(a.grid(), b.grid()))
        return Error{ErrorCode::argumentInvalid, "grid of the second volume", {}, "the grid of the first"};
    const auto isMaterial = [](PropertyIndex property) { return property != airProperty; };
    return Comparison(a.grid(), bricksThatHold(a, isMaterial), bricksThatHold(b, isMaterial))
        .run(
            true, [&](LineIndex line, std::vector<Interval>& out) { materialUnits(a.line(line), out); },
            [&](LineIndex line, std::vector<Interval>& out) { materialUnits(b.line(line), out); });
}

SpatialRelation relation(const VolumeSnapshot& volume, PropertyIndex a, PropertyIndex b) {
    const auto is = [](PropertyIndex wanted) { return [=](PropertyIndex property) { return property == wanted; }; };
    return Comparison(volume.grid(), bricksThatHold(volume, is(a)), bricksThatHold(volume, is(b)))
        .run(
            false, [&](LineIndex line, std::vector<Interval>& out) { intervalsOf(volume.line(line), a, out); },
            [&](LineIndex line, std::vector<Interval>& out) { intervalsOf(volume.line(line), b, out); });
}

} // namespace burin
