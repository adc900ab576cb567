// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/boundary/stock_search.h"

#include "core/cutting/footprint.h"
#include "core/geometry/convex_minimum.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double runTolerance = 1e-9;      // mm, of the minimum over a run
constexpr std::uint64_t visitsOfLook = 16; // for reading the 64 scanlines of a brick

/// The box around a piece, mm.
Box boxAroundPiece(const PlacedPiece& placed) noexcept {
    const auto& [tip, axis] = placed.pose();
    const RevolvedPiece& piece = placed.piece();
    const double widest = piece.widestRadius();
    Box box;
    for (int i = 0; i < 3; ++i) {
        const double across = widest * std::sqrt(std::max(0.0, 1.0 - axis[i] * axis[i]));
        const double bottom = tip[i] + piece.bottom * axis[i], top = tip[i] + piece.top * axis[i];
        box.low[i] = std::min(bottom, top) - across;
        box.high[i] = std::max(bottom, top) + across;
    }
    return box;
}

/// Calls `visit(first, last)` for each square of a raster that overlaps two ranges of lines, with its lines in them.
template <class Visit>
void forEachSquareOfLines(std::int32_t side, LineIndex first, LineIndex last, const Visit& visit) noexcept {
    for (std::int32_t v = first.v - first.v % side; v <= last.v; v += side)
        for (std::int32_t u = first.u - first.u % side; u <= last.u; u += side)
            visit(LineIndex{std::max(u, first.u), std::max(v, first.v)},
                  LineIndex{std::min(u + side - 1, last.u), std::min(v + side - 1, last.v)});
}

} // namespace

StockSearch::StockSearch(const RunVolume& workpiece, const CutCache* owed, OccupiedBricks& bricks, double within,
                         std::uint64_t& visited) noexcept
    : workpiece_(workpiece), owed_(owed), bricks_(bricks), visited_(visited) {
    nearest_.distance = within;
}

/// What is farther along the runs is not nearer than what was found. Beyond by one run unit: ends are rounded to them.
StockSearch::Range StockSearch::within(const Box& reach) const noexcept {
    const double margin = std::max(nearest_.distance, 0.0) + workpiece_.grid().edge() / unitsPerVoxel;
    return {reach.low.z - margin, reach.high.z + margin};
}

bool StockSearch::mayBeNearer(const PlacedPiece& piece, LineIndex first, LineIndex last, Range along) const noexcept {
    if (!(along.low <= along.high)) return false;
    const glm::dvec2 low = workpiece_.grid().lineCentre(first), high = workpiece_.grid().lineCentre(last);
    const glm::dvec3 centre(0.5 * (low + high), 0.5 * (along.low + along.high));
    const glm::dvec3 half(0.5 * (high - low), 0.5 * (along.high - along.low));
    const PlacedPiece::Value value = piece.at(centre);
    return value.distance - glm::dot(glm::abs(value.gradient), half) < nearest_.distance;
}

bool StockSearch::mayBeNearer(const PlacedPiece& piece, LineIndex first, LineIndex last, OccupiedBricks::Extent extent,
                              const Box& reach) const noexcept {
    if (extent.empty()) return false;
    const Grid& grid = workpiece_.grid();
    const double bottom = grid.toMillimetres(0);
    const Range near = within(reach);
    return mayBeNearer(piece, first, last,
                       {std::max(near.low, bottom + extent.low * grid.edge()),
                        std::min(near.high, bottom + extent.high * grid.edge())});
}

void StockSearch::search(const PlacedPiece& piece) noexcept {
    const Grid& grid = workpiece_.grid();
    const Box reach = boxAroundPiece(piece);
    const glm::dvec3 low = inLineFrame(grid, grid.low());
    const double margin = std::max(nearest_.distance, 0.0);
    const LineInterval us =
        linesWithin({reach.low.x - margin, reach.high.x + margin}, low.x, grid.edge(), grid.lineCountU());
    const LineInterval vs =
        linesWithin({reach.low.y - margin, reach.high.y + margin}, low.y, grid.edge(), grid.lineCountV());
    if (us.last < us.first || vs.last < vs.first) return;
    forEachSquareOfLines(
        OccupiedBricks::blockSide, {us.first, vs.first}, {us.last, vs.last}, [&](LineIndex first, LineIndex last) {
            ++visited_;
            if (!mayBeNearer(piece, first, last, bricks_.block(first), reach)) return;
            forEachSquareOfLines(OccupiedBricks::brickSide, first, last,
                                 [&](LineIndex from, LineIndex to) { searchBrick(piece, from, to, reach); });
        });
}

void StockSearch::searchBrick(const PlacedPiece& piece, LineIndex first, LineIndex last, const Box& reach) noexcept {
    ++visited_;
    if (!mayBeNearer(piece, first, last, bricks_.brick(first), reach)) return;
    visited_ += visitsOfLook;
    if (!mayBeNearer(piece, first, last, bricks_.lookAt(workpiece_, first), reach)) return;
    for (LineIndex line = first; line.v <= last.v; ++line.v)
        for (line.u = first.u; line.u <= last.u; ++line.u) searchLine(piece, line, reach);
}

void StockSearch::searchLine(const PlacedPiece& piece, LineIndex line, const Box& reach) noexcept {
    ++visited_;
    const Grid& grid = workpiece_.grid();
    const Range near = within(reach);
    const RunPosition from = grid.toRunPosition(near.low), to = grid.toRunPosition(near.high);
    if (from >= to || !mayBeNearer(piece, line, line, {grid.toMillimetres(from), grid.toMillimetres(to)})) return;
    forEachPieceNotOwed(workpiece_, owed_, line, from, to,
                        [&](PropertyIndex property, RunPosition start, RunPosition end) {
                            if (workpiece_.properties().isProtected(property)) return;
                            meet(piece, line, {grid.toMillimetres(start), grid.toMillimetres(end)});
                        });
}

void StockSearch::meet(const PlacedPiece& piece, LineIndex line, Range run) noexcept {
    const glm::dvec2 centre = workpiece_.grid().lineCentre(line);
    const auto along = [&](double z) noexcept -> LineValue {
        const PlacedPiece::Value value = piece.at({centre, z});
        return {value.distance, value.gradient.z};
    };
    const LineMinimum least = minimumOnLine(along, run.low, run.high, nearest_.distance, runTolerance);
    if (!(least.value < nearest_.distance)) return;
    nearest_.distance = least.value;
    nearest_.point = {centre, least.place};
    nearest_.gradient = piece.at(nearest_.point).gradient;
    nearest_.line = line;
    nearest_.any = true;
}

void StockSearch::tryLine(const PlacedPiece& piece, LineIndex line) noexcept {
    searchLine(piece, line, boxAroundPiece(piece));
}

} // namespace burin
