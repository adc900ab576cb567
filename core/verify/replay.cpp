// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/replay.h"

#include "core/base/parallel.h"
#include "core/base/parallel_progress.h"
#include "core/cutting/line_frame.h"
#include "core/verify/kept_rows.h"
#include "core/verify/row_replay.h"

#include <algorithm>
#include <iterator>
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
        const glm::dvec3 axis = inLineFrame(grid_, move.middleAxis());
        const double bottom = move.tilted() ? tool.guardBottomAt(axis) : tool.guardBottom;
        const bool guards = std::min(from.z, to.z) + bottom - tool.near < top;
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

/// What the moves did in each row of bricks.
struct ReplayedRows {
    explicit ReplayedRows(const Turns& rows) : turns(rows), results(rows.rowCount()) {}

    /// Calls `visit(entry, index of its move)` for all entries of a list, row after row.
    template <class Entry, class Visit>
    void forEach(std::vector<Entry> RowResult::*list, const Visit& visit) const {
        for (std::size_t row = 0; row < results.size(); ++row)
            if (results[row])
                for (const Entry& entry : *results[row].*list) visit(entry, turns.of(row)[entry.move]);
    }

    const Turns& turns;
    std::vector<std::shared_ptr<const RowResult>> results; ///< null: nothing comes near
};

void judgeRemoval(const ToolMove& move, const Tool& tool, const MoveCut& cut, Findings& findings) {
    if (cut.volume <= harmlessRemoval) return;
    if (move.rapid) findings.add(FindingKind::rapidInStock, move.line, cut.centroid, cut.volume);
    if (move.spindleOn != tool.cutter.turns())
        findings.add(move.spindleOn ? FindingKind::spindleOn : FindingKind::spindleOff, move.line, cut.centroid,
                     cut.volume);
}

std::vector<MoveCut> sumsOf(const ReplayedRows& rows, std::size_t moves, const Grid& grid) {
    std::vector<UnitSum> sums(moves);
    rows.forEach(&RowResult::cuts, [&](const MoveUnits& cut, std::uint32_t move) { sums[move].add(cut.sum); });
    std::vector<MoveCut> cuts(moves);
    for (std::size_t i = 0; i < moves; ++i)
        if (sums[i].units > 0) cuts[i] = {sums[i].volume(grid), sums[i].centroid(grid)};
    return cuts;
}

/// Merges equal steps of one move, in the order of rows, so that sums do not depend on the threads.
/// @return how many remain, at the front
std::size_t mergeSteps(std::span<StepCut> ofMove) {
    const auto key = [](const StepCut& cut) { return std::pair(cut.step, cut.material); };
    std::ranges::stable_sort(ofMove, {}, key);
    std::size_t count = 0;
    for (std::size_t i = 0; i < ofMove.size(); ++i) {
        if (count > 0 && key(ofMove[count - 1]) == key(ofMove[i]))
            ofMove[count - 1].add(ofMove[i]);
        else
            ofMove[count++] = ofMove[i];
    }
    return count;
}

/// The steps of all rows, in program order.
std::vector<StepCut> stepsOf(const ReplayedRows& rows, std::size_t moves) {
    std::vector<std::size_t> first(moves + 1);
    rows.forEach(&RowResult::steps, [&](const StepCut&, std::uint32_t move) { ++first[move + 1]; });
    for (std::size_t i = 0; i < moves; ++i) first[i + 1] += first[i];
    std::vector<StepCut> all(first.back());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    rows.forEach(&RowResult::steps, [&](const StepCut& cut, std::uint32_t move) {
        StepCut& placed = all[next[move]++] = cut;
        placed.move = move;
    });
    std::vector<std::size_t> remaining(moves);
    parallelIntervals(std::size_t{0}, moves, 256, [&](std::size_t from, std::size_t end) {
        for (std::size_t i = from; i != end; ++i)
            remaining[i] = mergeSteps(std::span(all).subspan(first[i], first[i + 1] - first[i]));
    });
    auto out = all.begin();
    for (std::size_t i = 0; i < moves; ++i) {
        const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first[i]);
        out = std::move(begin, begin + static_cast<std::ptrdiff_t>(remaining[i]), out);
    }
    all.erase(out, all.end());
    return all;
}

/// The overlap of shank and holder after one step, over the whole grid.
struct Contact {
    std::map<std::uint32_t, std::uint64_t> byPiece;
    UnitSum sum;
};

void judgeContacts(const ReplayedRows& rows, const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                   const Grid& grid, Findings& findings) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, Contact> contacts;
    rows.forEach(&RowResult::contacts, [&](const StepContact& step, std::uint32_t move) {
        Contact& contact = contacts[{move, step.step}];
        contact.byPiece[step.piece] += step.sum.units;
        contact.sum.add(step.sum);
    });
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
void tellPasses(const ReplayedRows& rows, const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                const Grid& grid, NearPasses& passes) {
    std::set<std::pair<std::uint32_t, ToolSection>> touching;
    rows.forEach(&RowResult::contacts, [&](const StepContact& contact, std::uint32_t move) {
        touching.insert({move, sectionOf(tools[moves[move].tool].cutter, contact.piece)});
    });
    rows.forEach(&RowResult::passes, [&](const StockPass& pass, std::uint32_t move) {
        if (!touching.contains({move, pass.section}))
            passes.add({pass.section, NearTo::stock, moves[move].line, pass.sum.centroid(grid), pass.distance});
    });
}

/// A replay, before and after its rows are cut.
class Replay {
public:
    Replay(const std::vector<ToolMove>& moves, std::span<const Tool> tools, const RunVolume& fresh, NearWatch near,
           std::vector<StepCut>* steps, const ExactStock* exact)
        : moves_(moves)
        , tools_(tools)
        , grid_(fresh.grid())
        , near_(near)
        , steps_(steps)
        , exact_(exact)
        , prepared_(prepare(tools, grid_, near.passes != nullptr ? near.distance : 0.0))
        , turns_(moves, prepared_, fresh)
        , rows_(turns_) {}
    Replay(const Replay&) = delete;
    Replay& operator=(const Replay&) = delete;

    const Turns& turns() const noexcept { return turns_; }
    ReplayedRows& rows() noexcept { return rows_; }

    /// Makes the moves of a row. Any thread, one for each row.
    void run(std::size_t row, RowStock& stock, const Progress& progress) {
        rows_.results[row] = std::make_shared<const RowResult>(
            RowReplay(stock, grid_, moves_, prepared_, steps_ != nullptr, exact_ != nullptr)
                .run(turns_.of(row), progress));
    }

    std::vector<MoveCut> conclude(Findings& findings, const Progress& progress) {
        std::vector<MoveCut> cuts = sumsOf(rows_, moves_.size(), grid_);
        for (std::size_t i = 0; i < moves_.size(); ++i)
            judgeRemoval(moves_[i], tools_[moves_[i].tool], cuts[i], findings);
        if (exact_ != nullptr) {
            std::vector<GrazedLine> grazed;
            rows_.forEach(&RowResult::grazed, [&](const GrazedLine& line, std::uint32_t move) {
                grazed.push_back({move, line.line});
            });
            judgeGrazes(grazed, moves_, tools_, grid_, *exact_, findings, progress);
        }
        judgeContacts(rows_, moves_, tools_, grid_, findings);
        if (steps_ != nullptr) *steps_ = stepsOf(rows_, moves_.size());
        if (near_.passes != nullptr) tellPasses(rows_, moves_, tools_, grid_, *near_.passes);
        return cuts;
    }

private:
    static std::vector<ReplayTool> prepare(std::span<const Tool> tools, const Grid& grid, double near) {
        std::vector<ReplayTool> prepared;
        for (const Tool& tool : tools) prepared.emplace_back(tool.cutter, grid, near);
        return prepared;
    }

    const std::vector<ToolMove>& moves_;
    std::span<const Tool> tools_;
    const Grid& grid_;
    NearWatch near_;
    std::vector<StepCut>* steps_;
    const ExactStock* exact_;
    std::vector<ReplayTool> prepared_;
    Turns turns_;
    ReplayedRows rows_;
};

/// Copies a brick as it is.
template <class Source>
void copyBrick(const Source& source, LineIndex corner, BrickLines& lines) {
    const Grid& grid = source.grid();
    lines.clear();
    if (grid.contains(LineIndex{corner.u + brickSide - 1, corner.v + brickSide - 1})) {
        const std::span<const Segment> all = source.brick(corner);
        lines.writeAll(all.size(), [&](Segment* segments, std::uint32_t* offsets) {
            std::ranges::copy(all, segments);
            *offsets = 0;
            for (std::size_t i = 0; i < all.size(); ++i)
                if (all[i].end() == grid.lineEnd()) *++offsets = static_cast<std::uint32_t>(i + 1);
        });
        return;
    }
    for (std::int32_t v = corner.v; v < corner.v + brickSide; ++v)
        for (std::int32_t u = corner.u; u < corner.u + brickSide; ++u) {
            if (grid.contains(LineIndex{u, v})) lines.append(source.line({u, v}));
            lines.endLine();
        }
}

/// Hands over a row of bricks as it is.
template <class Source>
void copyRow(const Source& source, std::int32_t row, BrickSink& sink) {
    BrickLines lines(source.grid().lineEnd());
    for (LineIndex corner{0, row * brickSide}; corner.u < source.grid().lineCountU(); corner.u += brickSide) {
        copyBrick(source, corner, lines);
        sink.put(corner, lines);
    }
}

} // namespace

Result<std::vector<MoveCut>> replay(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                                    RunVolume& workpiece, Findings& findings, Progress& progress, NearWatch near,
                                    std::vector<StepCut>* steps, const ExactStock* exact) {
    Replay replay(moves, tools, workpiece, near, steps, exact);
    ParallelProgress shared(progress, replay.turns().rowCount());
    const bool written = workpiece.rewriteBricks([&](std::int32_t row, BrickSink& sink) {
        const auto place = static_cast<std::size_t>(row);
        if (replay.turns().of(place).empty() || progress.cancelled()) return;
        RowStock stock(workpiece, row);
        replay.run(place, stock, progress);
        BrickLines lines(workpiece.grid().lineEnd());
        for (std::int32_t brick = 0; brick < stock.brickCount(); ++brick) {
            if (!stock.isCut(brick)) continue;
            stock.brick(brick, lines);
            sink.put({brick * brickSide, stock.firstV()}, lines);
        }
        shared.add();
    });
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "verification", {}, {}};
    if (!written) return Error{ErrorCode::volumeOutOfMemory, std::to_string(workpiece.reservedBytes()), {}, {}};
    return replay.conclude(findings, progress);
}

Result<MachinedWorkpiece> replay(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                                 const RunVolume& fresh, KeptRows& kept, std::span<const std::uint32_t> numbers,
                                 Findings& findings, Progress& progress, NearWatch near, std::vector<StepCut>* steps,
                                 const ExactStock* exact) {
    Replay replay(moves, tools, fresh, near, steps, exact);
    std::vector<KeptRows::Row> rows(replay.turns().rowCount());
    ParallelProgress shared(progress, rows.size());
    const auto describe = [&](std::int32_t row, BrickSink& sink) {
        const auto place = static_cast<std::size_t>(row);
        if (progress.cancelled()) return;
        std::vector<std::uint32_t>& coming = rows[place].moves;
        coming.clear(); // called again if the memory did not suffice
        for (const std::uint32_t move : replay.turns().of(place)) coming.push_back(numbers[move]);
        if (coming.empty()) return copyRow(fresh, row, sink);
        if (auto known = kept.find(place, coming)) {
            replay.rows().results[place] = std::move(known);
            return copyRow(kept.machined(), row, sink);
        }
        RowStock stock(fresh, row);
        replay.run(place, stock, progress);
        BrickLines lines(fresh.grid().lineEnd());
        for (std::int32_t brick = 0; brick < stock.brickCount(); ++brick) {
            const LineIndex corner{brick * brickSide, stock.firstV()};
            stock.isCut(brick) ? stock.brick(brick, lines) : copyBrick(fresh, corner, lines);
            sink.put(corner, lines);
        }
        shared.add();
    };
    for (std::size_t reserve = fresh.reservedBytes();; reserve *= 2) {
        Result<RunVolume> machined = RunVolume::make(fresh.grid(), fresh.properties(), reserve);
        if (!machined) return std::move(machined).error();
        const bool written = machined->rewriteBricks(describe);
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "verification", {}, {}};
        if (!written) continue;
        for (std::size_t i = 0; i < rows.size(); ++i) rows[i].result = replay.rows().results[i];
        kept.keep(std::move(rows), machined->snapshot());
        return MachinedWorkpiece{replay.conclude(findings, progress), std::move(*machined)};
    }
}

} // namespace burin
