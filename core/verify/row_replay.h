// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/cutting/footprint.h"
#include "core/cutting/solid_columns.h"
#include "core/verify/cut_filter.h"
#include "core/verify/rapid_graze.h"
#include "core/verify/row_stock.h"
#include "core/verify/step_meter.h"
#include "core/verify/tool_moves.h"

#include <memory>
#include <span>
#include <vector>

namespace burin {

/// A tool, prepared for the replay on the lines of a grid.
struct ReplayTool {
    /// @param nearDistance distance below which a pass of shank or holder is reported, mm
    ReplayTool(const Cutter& cutter, const Grid& grid, double nearDistance = 0.0);

    std::vector<RevolvedPiece> stack; ///< pieces(cutter)
    std::size_t fluteCount = 0;       ///< number of them that cut, counted from the tip
    std::vector<RevolvedPiece> wider; ///< the flutes, grown by up to a voxel
    double fluteRadius = 0.0;         ///< mm, widest
    double guardBottom = 0.0;         ///< mm along the runs from the tip of an upright tool: as guardBottomAt
    bool upright = true;              ///< the axis of an upright tool is parallel to the runs
    std::size_t shankCount = 0;       ///< number of pieces after the flutes that belong to the shank
    double near = 0.0;                ///< mm; 0: not requested
    CutFilter filter;
    std::shared_ptr<const SolidColumns> solid; ///< null: the pieces cut
    bool turns = true;                         ///< only then it has loads
    PlanRegion section;                        ///< ToolSolid::section, oriented, of hollow flutes; or empty

    /// Number of pieces, from the tip, whose contact with the stock is not judged by the pieces: the flutes, and a
    /// shank that has a model of its own.
    std::size_t guardFirst() const noexcept { return fluteCount + (hasSolidShank() ? shankCount : 0); }
    bool hasSolidShank() const noexcept { return solid && solid->hasShank(); }
    /// mm along the runs from the tip: lower limit of shank and holder. @param axis of the tool, line frame
    double guardBottomAt(const glm::dvec3& axis) const noexcept;
};

// Results in one row of bricks name a move by its place among the moves that come near the row (`turns`): where these
// are the same in two programs, so are the results.

/// What a move removed in one row of bricks.
struct MoveUnits {
    std::uint32_t move = 0;
    UnitSum sum;
};
/// The overlap of a piece that must not touch anything with one row of bricks, after a step of a move.
struct StepContact {
    std::uint32_t move = 0, step = 0, piece = 0;
    UnitSum sum;
};
/// A section that passed the material standing in one row of bricks after a move, without touching it.
struct StockPass {
    std::uint32_t move = 0;
    ToolSection section = ToolSection::shank;
    double distance = 0.0; ///< mm, rounded down by at most `passResolution`
    UnitSum sum;           ///< the material that is that near
};
struct RowResult {
    std::vector<MoveUnits> cuts;
    std::vector<StockPass> passes;
    std::vector<StepContact> contacts;
    std::vector<GrazedLine> grazed; ///< of rapids, if the tool is upright
    std::vector<StepCut> steps;     ///< of the feed moves, if requested; ascending by move and step
};

/// Resolution of reported distances to stock, mm, in addition to that of the runs themselves.
inline constexpr double passResolution = 1.0 / 32.0;

/// Makes moves, in order, in one row of bricks. Lines are independent of each other, so rows can be processed in any
/// order and by any number of threads, and their sums are those of the moves made one by one over the whole grid.
///
/// The flutes of a move cut in one go, swept exactly. The sweep of shank and holder over the whole move is compared
/// with what stands before the move: if it overlaps nothing, no step of it does. Only otherwise the move is made in
/// steps of at most a voxel, and each step is cut before it is examined. A tool that doesn't turn or is hollow cuts,
/// and touches with a shank of its own, as a solid (SolidColumns); its grazes and near passes of that shank are not
/// examined, nor the loads of one that doesn't turn.
class RowReplay {
public:
    /// @param meters whether RowResult::steps is requested @param grazes whether RowResult::grazed is requested
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

    /// @param turns indices of moves, ascending
    /// @return `move` in the results: index in `turns`
    RowResult run(std::span<const std::uint32_t> turns, const Progress& progress);

private:
    struct Flute {
        SweptPiece swept;
        bool throughTop; ///< its spans reach above the grid on the whole move
    };
    void make(const ToolMove& move, std::uint32_t number);
    void cutUpright(const ReplayTool& tool, const glm::dvec3& from, const glm::dvec3& to, UnitSum& removed);
    void cutSwept(const ReplayTool& tool, const glm::dvec3& from, const glm::dvec3& to, UnitSum& removed);
    void cutSolid(const SolidColumns& solid, const glm::dvec3& from, const glm::dvec3& to, UnitSum& removed);
    bool shankTouches(const SolidColumns& solid, const glm::dvec3& from, const glm::dvec3& to) const;
    void lookAtShank(const ReplayTool& tool, const glm::dvec3& tip, std::uint32_t number, std::uint32_t step);
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
    LineInterval rows() const noexcept { return {stock_.firstV(), stock_.firstV() + stock_.lineCountV() - 1}; }

    RowStock& stock_;
    const Grid& grid_;
    std::span<const ToolMove> moves_;
    std::span<const ReplayTool> tools_;
    glm::dvec3 axis_{0.0};      ///< of the tool on the current move, line frame
    double guardBottom_ = 0.0;  ///< of the current move, as ReplayTool::guardBottom
    std::int32_t reach_;        ///< run units: upper limit of everything in the row
    std::vector<Flute> flutes_; ///< of the current move
    StepMeter meter_;
    bool meters_; ///< whether requested at all
    bool grazes_;
    bool metered_ = false; ///< whether the current move is metered
    RowResult result_;
};

/// Number of steps that a move is made in where shank or holder may touch.
std::uint32_t stepsOf(const ToolMove& move, double edge) noexcept;

} // namespace burin
