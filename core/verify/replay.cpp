// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/replay.h"

#include "core/base/parallel_progress.h"
#include "core/cutting/line_frame.h"
#include "core/verify/row_replay.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace burin {

namespace {

/// A rapid that grazes what was just cut removes nothing: both use the same lines and the same rounding. The remaining
/// tolerance is one run unit on the lines of a voxel's face.
constexpr double harmlessRemoval = 1e-3; // mm³

/// The moves that come near each row of bricks, in order.
class Turns {
public:
    Turns(const std::vector<ToolMove>& moves, std::span<const ReplayTool> tools, const RunVolume& workpiece)
        : grid_(workpiece.grid()), first_(rowCount() + 1) {
        std::vector<LineInterval> rows(moves.size());
        const double top = topOf(workpiece);
        for (std::size_t i = 0; i < moves.size(); ++i) {
            rows[i] = rowsOf(moves[i], tools[moves[i].tool], top);
            for (std::int32_t row = rows[i].first; row <= rows[i].last; ++row)
                ++first_[static_cast<std::size_t>(row) + 1];
        }
        for (std::size_t row = 1; row < first_.size(); ++row) first_[row] += first_[row - 1];
        moves_.resize(first_.back());
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        for (std::size_t i = 0; i < moves.size(); ++i)
            for (std::int32_t row = rows[i].first; row <= rows[i].last; ++row)
                moves_[next[static_cast<std::size_t>(row)]++] = static_cast<std::uint32_t>(i);
    }

    std::size_t rowCount() const noexcept {
        return static_cast<std::size_t>((grid_.lineCountV() + brickSide - 1) / brickSide);
    }
    std::span<const std::uint32_t> of(std::size_t row) const noexcept {
        return std::span(moves_).subspan(first_[row], first_[row + 1] - first_[row]);
    }

private:
    /// Upper limit of all material along the runs, mm, line frame.
    static double topOf(const RunVolume& workpiece) {
        const Grid& grid = workpiece.grid();
        RunPosition highest = 0;
        for (LineIndex line{0, 0}; line.v < grid.lineCountV(); ++line.v)
            for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
                const std::span<const Segment> segments = workpiece.line(line);
                const std::size_t last = segments.size();
                if (segments[last - 1].property() != airProperty)
                    highest = grid.lineEnd();
                else if (last > 1)
                    highest = std::max(highest, segments[last - 2].end());
            }
        return grid.toMillimetres(highest);
    }
    /// Rows of bricks; last < first if there is none.
    LineInterval rowsOf(const ToolMove& move, const ReplayTool& tool, double top) const {
        if (!move.endKnown) return {};
        const glm::dvec3 from = inLineFrame(grid_, move.begin().tip), to = inLineFrame(grid_, move.to.tip);
        const glm::dvec3 axis = inLineFrame(grid_, glm::dvec3(0.0, 0.0, 1.0));
        const bool guards = std::min(from.z, to.z) + tool.guardBottom - tool.near < top;
        Box reach;
        for (std::size_t i = 0; i < (guards ? tool.stack.size() : tool.fluteCount); ++i) {
            Box piece = SweptPiece(tool.stack[i], from, to, axis).bounds();
            if (i >= tool.fluteCount)
                piece = piece.grown(tool.near);
            else if (move.rapid)
                piece = piece.grown(grid_.edge());             // for what it may graze
            if (tool.solid) piece = piece.grown(grid_.edge()); // its tip is moved to a lattice
            if (piece.low.z < top) reach.include(piece);
        }
        if (reach.empty()) return {};
        const glm::dvec3 low = inLineFrame(grid_, grid_.low());
        const LineInterval columns = linesWithin({reach.low.x, reach.high.x}, low.x, grid_.edge(), grid_.lineCountU());
        const LineInterval lines = linesWithin({reach.low.y, reach.high.y}, low.y, grid_.edge(), grid_.lineCountV());
        if (columns.last < columns.first || lines.last < lines.first || reach.high.z <= low.z) return {};
        return {lines.first / brickSide, lines.last / brickSide};
    }

    const Grid& grid_;
    std::vector<std::size_t> first_;
    std::vector<std::uint32_t> moves_;
};

void judgeRemoval(const ToolMove& move, const Tool& tool, const MoveCut& cut, Findings& findings) {
    if (cut.volume <= harmlessRemoval) return;
    if (move.rapid) findings.add(FindingKind::rapidInStock, move.line, cut.centroid, cut.volume);
    if (move.spindleOn != tool.cutter.turns())
        findings.add(move.spindleOn ? FindingKind::spindleOn : FindingKind::spindleOff, move.line, cut.centroid,
                     cut.volume);
}

std::vector<MoveCut> sumsOf(const std::vector<RowResult>& rows, std::size_t moves, const Grid& grid) {
    std::vector<UnitSum> sums(moves);
    for (const RowResult& row : rows)
        for (const MoveUnits& cut : row.cuts) sums[cut.move].add(cut.sum);
    std::vector<MoveCut> cuts(moves);
    for (std::size_t i = 0; i < moves; ++i)
        if (sums[i].units > 0) cuts[i] = {sums[i].volume(grid), sums[i].centroid(grid)};
    return cuts;
}

/// Merges the steps of all rows, in program order; equal steps in the order of rows, so that sums do not depend on the
/// threads.
std::vector<StepCut> stepsOf(std::vector<RowResult>& rows) {
    std::vector<StepCut> all;
    for (RowResult& row : rows) {
        all.insert(all.end(), row.steps.begin(), row.steps.end());
        row.steps = {};
    }
    const auto key = [](const StepCut& cut) { return std::tuple(cut.move, cut.step, cut.material); };
    std::ranges::stable_sort(all, {}, key);
    std::size_t count = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (count > 0 && key(all[count - 1]) == key(all[i]))
            all[count - 1].add(all[i]);
        else
            all[count++] = all[i];
    }
    all.resize(count);
    return all;
}

/// The overlap of shank and holder after one step, over the whole grid.
struct Contact {
    std::map<std::uint32_t, std::uint64_t> byPiece;
    UnitSum sum;
};

void judgeContacts(const std::vector<RowResult>& rows, const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                   const Grid& grid, Findings& findings) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, Contact> contacts;
    for (const RowResult& row : rows)
        for (const StepContact& step : row.contacts) {
            Contact& contact = contacts[{step.move, step.step}];
            contact.byPiece[step.piece] += step.sum.units;
            contact.sum.add(step.sum);
        }
    for (const auto& [place, contact] : contacts) {
        const ToolMove& move = moves[place.first];
        const auto most = std::max_element(contact.byPiece.begin(), contact.byPiece.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        const bool shank = sectionOf(tools[move.tool].cutter, most->first) == ToolSection::shank;
        findings.add(shank ? FindingKind::shankCollision : FindingKind::holderCollision, move.line,
                     contact.sum.centroid(grid), contact.sum.volume(grid));
    }
}

/// Reports for each move the nearest pass over all rows, unless the section touches something: its line then has a
/// finding.
void tellPasses(const std::vector<RowResult>& rows, const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                const Grid& grid, NearPasses& passes) {
    std::set<std::pair<std::uint32_t, ToolSection>> touching;
    for (const RowResult& row : rows)
        for (const StepContact& contact : row.contacts)
            touching.insert({contact.move, sectionOf(tools[moves[contact.move].tool].cutter, contact.piece)});
    for (const RowResult& row : rows)
        for (const StockPass& pass : row.passes)
            if (!touching.contains({pass.move, pass.section}))
                passes.add(
                    {pass.section, NearTo::stock, moves[pass.move].line, pass.sum.centroid(grid), pass.distance});
}

} // namespace

Result<std::vector<MoveCut>> replay(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                                    RunVolume& workpiece, Findings& findings, Progress& progress, NearWatch near,
                                    std::vector<StepCut>* steps, const ExactStock* exact) {
    const Grid& grid = workpiece.grid();
    std::vector<ReplayTool> replayTools;
    for (const Tool& tool : tools)
        replayTools.emplace_back(tool.cutter, grid, near.passes != nullptr ? near.distance : 0.0);
    const Turns turns(moves, replayTools, workpiece);
    std::vector<RowResult> rows(turns.rowCount());
    ParallelProgress shared(progress, rows.size());
    const bool written = workpiece.rewriteBricks([&](std::int32_t row, BrickSink& sink) {
        const auto place = static_cast<std::size_t>(row);
        if (turns.of(place).empty() || progress.cancelled()) return;
        RowStock stock(workpiece, row);
        rows[place] = RowReplay(stock, grid, moves, replayTools, steps != nullptr, exact != nullptr)
                          .run(turns.of(place), progress);
        BrickLines lines(grid.lineEnd());
        for (std::int32_t brick = 0; brick < stock.brickCount(); ++brick) {
            if (!stock.isCut(brick)) continue;
            stock.brick(brick, lines);
            sink.put({brick * brickSide, stock.firstV()}, lines);
        }
        shared.add();
    });
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "verification", {}, {}};
    if (!written) return Error{ErrorCode::volumeOutOfMemory, std::to_string(workpiece.reservedBytes()), {}, {}};
    std::vector<MoveCut> cuts = sumsOf(rows, moves.size(), grid);
    for (std::size_t i = 0; i < moves.size(); ++i) judgeRemoval(moves[i], tools[moves[i].tool], cuts[i], findings);
    if (exact != nullptr) {
        std::vector<GrazedLine> grazed;
        for (const RowResult& row : rows) grazed.insert(grazed.end(), row.grazed.begin(), row.grazed.end());
        judgeGrazes(grazed, moves, tools, grid, *exact, findings, progress);
    }
    judgeContacts(rows, moves, tools, grid, findings);
    if (steps != nullptr) *steps = stepsOf(rows);
    if (near.passes != nullptr) tellPasses(rows, moves, tools, grid, *near.passes);
    return cuts;
}

} // namespace burin
