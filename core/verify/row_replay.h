// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/cutting/footprint.h"
#include "core/verify/cut_filter.h"
#include "core/verify/rapid_graze.h"
#include "core/verify/row_stock.h"
#include "core/verify/step_meter.h"
#include "core/verify/tool_moves.h"

#include <span>
#include <vector>

namespace burin {

/// A tool, ready to be replayed among the lines of a grid.
struct ReplayTool {
    /// @param nearDistance mm: how near shank and holder may pass before it is told
    ReplayTool(const Cutter& cutter, const Grid& grid, double nearDistance = 0.0);

    std::vector<RevolvedPiece> stack; ///< pieces(cutter)
    std::size_t fluteCount = 0;       ///< so many of them, from the tip, cut
    std::vector<RevolvedPiece> wider; ///< the flutes and all that is less than a voxel beside them
    double fluteRadius = 0.0;         ///< mm, widest
    double guardBottom = 0.0;         ///< mm along the runs from the tip: shank and holder reach no lower
    bool upright = true;              ///< the axis lies along the runs
    std::size_t shankCount = 0;       ///< of the pieces behind the flutes
    double near = 0.0;                ///< mm; 0: nobody asks
    CutFilter filter;
};

/// What a move took of one row of bricks.
struct MoveUnits {
    std::uint32_t move = 0;
    UnitSum sum;
};
/// What a piece that must not touch overlapped of one row of bricks after a step of a move.
struct StepContact {
    std::uint32_t move = 0, step = 0, piece = 0;
    UnitSum sum;
};
/// A section that passed what stood in one row of bricks after a move, without touching it.
struct StockPass {
    std::uint32_t move = 0;
    ToolSection section = ToolSection::shank;
    double distance = 0.0; ///< mm, rounded down by `passResolution` at most
    UnitSum sum;           ///< what is that near
};
struct RowResult {
    std::vector<MoveUnits> cuts;
    std::vector<StockPass> passes;
    std::vector<StepContact> contacts;
    std::vector<GrazedLine> grazed; ///< of rapids, where the tool is upright
    std::vector<StepCut> steps;     ///< of the feed moves, where they are asked for; rising move and step
};

/// Distances to stock are told to so much, mm, beside what the runs themselves know it to.
inline constexpr double passResolution = 1.0 / 32.0;

/// Makes moves, in order, in one row of bricks. Lines do not know of each other, so that rows can be made in any order
/// and by any number of threads, and their sums are those of the moves made one by one over the whole grid.
///
/// A move's flutes cut in one go, swept exactly. Shank and holder are asked for as what they sweep on the whole move in
/// what stands before it: where that overlaps nothing no step of it does. Only else the move is made in steps of at
/// most a voxel, each cut before it is looked at.
class RowReplay {
public:
    /// @param meters whether RowResult::steps is asked for  @param grazes the same of RowResult::grazed
    RowReplay(RowStock& stock, const Grid& grid, std::span<const ToolMove> moves, std::span<const ReplayTool> tools,
              bool meters = false, bool grazes = false)
        : stock_(stock)
        , grid_(grid)
        , moves_(moves)
        , tools_(tools)
        , reach_(stock.reach())
        , meter_(stock.volume())
        , meters_(meters)
        , grazes_(grazes) {}

    /// @param turns places in the moves, rising
    RowResult run(std::span<const std::uint32_t> turns, const Progress& progress);

private:
    struct Flute {
        SweptPiece swept;
        bool throughTop; ///< above all of the way its lines end over the grid
    };
    void make(std::uint32_t number);
    void cutUpright(const ReplayTool& tool, const glm::dvec3& from, const glm::dvec3& to, UnitSum& removed);
    void cutSwept(const ReplayTool& tool, const glm::dvec3& from, const glm::dvec3& to, UnitSum& removed);
    void take(LineIndex line, RunPosition from, RunPosition to, UnitSum& removed);
    void cutBrick(std::int32_t brick, std::uint64_t lines, UnitSum& removed);
    void lookGrazed(const ReplayTool& tool, const glm::dvec3& from, const glm::dvec3& to, std::uint32_t number);
    bool mayTouch(const ReplayTool& tool, const glm::dvec3& from, const glm::dvec3& to) const;
    bool touches(const SweptPiece& piece, RunPosition tolerance) const;
    void lookNear(const ReplayTool& tool, const glm::dvec3& from, const glm::dvec3& to, std::uint32_t number);
    void lookNear(std::span<const RevolvedPiece> section, ToolSection which, double near, const glm::dvec3& from,
                  const glm::dvec3& to, std::uint32_t number);
    bool isNear(std::span<const RevolvedPiece> section, double by, const glm::dvec3& from, const glm::dvec3& to,
                UnitSum& sum) const;
    void lookAt(const ReplayTool& tool, const glm::dvec3& tip, std::uint32_t number, std::uint32_t step);
    LineStretch rows() const noexcept { return {stock_.firstV(), stock_.firstV() + stock_.lineCountV() - 1}; }

    RowStock& stock_;
    const Grid& grid_;
    std::span<const ToolMove> moves_;
    std::span<const ReplayTool> tools_;
    std::int32_t reach_;        ///< run units, of all that the row holds
    std::vector<Flute> flutes_; ///< of the move
    StepMeter meter_;
    bool meters_; ///< asked for at all
    bool grazes_;
    bool metered_ = false; ///< of this move
    RowResult result_;
};

/// Steps that a move is made in where shank or holder may touch.
std::uint32_t stepsOf(const ToolMove& move, double edge) noexcept;

} // namespace burin
