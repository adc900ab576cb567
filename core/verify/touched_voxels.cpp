// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/touched_voxels.h"

#include "core/cutting/contact.h"
#include "core/verify/findings.h"
#include "core/verify/replay.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace burin {

namespace {

/// The lines with the largest overlaps.
std::set<std::uint32_t> linesOf(const std::vector<Finding>& found) {
    std::map<std::uint32_t, double> overlap;
    for (const Finding& finding : found)
        if (isShankOrHolder(finding)) overlap[finding.line] = std::max(overlap[finding.line], finding.amount);
    std::vector<std::pair<double, std::uint32_t>> byAmount;
    for (const auto& [line, amount] : overlap) byAmount.emplace_back(-amount, line);
    std::ranges::sort(byAmount);
    std::set<std::uint32_t> lines;
    for (const auto& [amount, line] : byAmount)
        if (lines.size() < mostTouched) lines.insert(line);
    return lines;
}

/// Makes the moves once, and stops at the lines in question.
class TouchSearch {
public:
    TouchSearch(const std::vector<ToolMove>& moves, std::span<const Tool> tools, RunVolume& workpiece,
                Progress& progress)
        : moves_(moves), tools_(tools), workpiece_(workpiece), progress_(progress) {}

    Result<TouchedVoxels> at(std::uint32_t line) {
        const auto first =
            static_cast<std::size_t>(std::ranges::find(moves_.begin() + static_cast<std::ptrdiff_t>(done_),
                                                       moves_.end(), line, &ToolMove::line) -
                                     moves_.begin());
        if (Result<void> cut = cutMoves({moves_.begin() + static_cast<std::ptrdiff_t>(done_),
                                         moves_.begin() + static_cast<std::ptrdiff_t>(first)});
            !cut)
            return std::move(cut).error();
        worst_ = {};
        worst_.line = line;
        overlap_ = 0.0;
        for (done_ = first; done_ < moves_.size() && moves_[done_].line == line; ++done_)
            if (Result<void> made = makeInSteps(moves_[done_]); !made) return std::move(made).error();
        return std::move(worst_);
    }

private:
    Result<void> cutMoves(const std::vector<ToolMove>& moves) {
        if (moves.empty()) return {};
        Findings ignored; // they are already reported
        const Result<std::vector<MoveCut>> cuts = replay(moves, tools_, workpiece_, ignored, progress_);
        return cuts ? Result<void>() : cuts.error();
    }

    Result<void> makeInSteps(const ToolMove& move) {
        const double length = glm::length(move.to.tip - move.begin().tip);
        const auto steps = static_cast<int>(std::max(1.0, std::ceil(length / workpiece_.grid().edge())));
        for (int k = 0; k < steps; ++k) {
            ToolMove step = move;
            step.from.tip = glm::mix(move.begin().tip, move.to.tip, static_cast<double>(k) / steps);
            step.to.tip = glm::mix(move.begin().tip, move.to.tip, static_cast<double>(k + 1) / steps);
            if (Result<void> cut = cutMoves({step}); !cut) return cut;
            look(step);
        }
        return {};
    }

    void look(const ToolMove& move) {
        const Cutter& cutter = tools_[move.tool].cutter;
        const std::vector<RevolvedPiece> all = pieces(cutter);
        const std::size_t flutes = flutePieces(cutter).size();
        const double overlap = shankContact(workpiece_, all, flutes, move.to).volume;
        if (overlap <= overlap_) return;
        overlap_ = overlap;
        worst_.pose = move.to;
        worst_.centres.clear();
        const Grid& grid = workpiece_.grid();
        worst_.edge = grid.edge();
        for (const VoxelIndex& voxel : collisionArea(workpiece_.snapshot(), all, flutes, move.to))
            worst_.centres.emplace_back(grid.low() + (glm::dvec3(voxel.i, voxel.j, voxel.k) + 0.5) * grid.edge());
    }

    const std::vector<ToolMove>& moves_;
    std::span<const Tool> tools_;
    RunVolume& workpiece_;
    Progress& progress_;
    std::size_t done_ = 0;
    TouchedVoxels worst_;
    double overlap_ = 0.0;
};

} // namespace

bool isShankOrHolder(const Finding& finding) noexcept {
    return finding.kind == FindingKind::shankCollision || finding.kind == FindingKind::holderCollision;
}

Result<std::vector<TouchedVoxels>> findTouchedVoxels(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                                                     RunVolume& workpiece, const std::vector<Finding>& found,
                                                     Progress& progress) {
    std::vector<TouchedVoxels> touched;
    const std::set<std::uint32_t> lines = linesOf(found);
    if (lines.empty()) return touched;
    TouchSearch search(moves, tools, workpiece, progress);
    for (const std::uint32_t line : lines) {
        Result<TouchedVoxels> area = search.at(line);
        if (!area) return std::move(area).error();
        if (!area->centres.empty()) touched.push_back(std::move(*area));
    }
    return touched;
}

} // namespace burin
