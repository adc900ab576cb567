// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/surface_pass.h"

#include "core/base/parallel.h"
#include "core/base/parallel_progress.h"
#include "core/base/units.h"
#include "core/passes/surface_trace.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace burin {
namespace {

constexpr double coarsest = 0.2;        // mm between points of an engraved line
constexpr double depthTolerance = 1e-6; // mm

class RowPlanner {
public:
    RowPlanner(const PassRequest& request, const PassGround& ground, Progress& progress)
        : request_(request), ground_(ground), progress_(progress), trace_(request, ground) {}

    Result<PlannedPass> plan() {
        if (ground_.part.bounds().empty())
            return Error{ErrorCode::argumentInvalid, "pass", std::string(rowOf(request_.kind).id),
                         "a part to lay rows on; there is none"};
        const Result<double> stepOver = stepOverOf(request_, ground_.tool.cutter);
        if (!stepOver) return stepOver.error();
        stepOver_ = *stepOver * ground_.coarseness;
        const Result<std::vector<PlanRow>> made = rowsOnPart();
        if (!made) return made.error();
        const std::vector<PlanRow>& rows = *made;
        const ProgressPart part(progress_, 0.5, 1.0);
        std::vector<std::vector<TipLine>> intervals(rows.size());
        std::vector<double> leftOut(rows.size(), 0.0);
        ParallelProgress done(progress_, rows.size());
        parallelFor(std::size_t{0}, rows.size(), [&](std::size_t i) {
            if (progress_.cancelled()) return;
            intervals[i] = trace_.along(rows[i], leftOut[i]);
            done.add();
        });
        if (progress_.cancelled()) return Error{ErrorCode::cancelled, "pass", "", ""};
        for (const double one : leftOut) planned_.leftOut += one;
        for (std::vector<TipLine>& row : intervals) addRow(std::move(row));
        for (TipLine& stroke : planned_.strokes) stroke = straightened(stroke);
        return std::move(planned_);
    }

private:
    Result<std::vector<PlanRow>> rowsOnPart() const {
        const ProgressPart part(progress_, 0.0, 0.5);
        const bool ball = ground_.tool.cutter.cornerRadius >= ground_.tool.cutter.radius();
        if (request_.hand == HandStrokes::extend) {
            const HandFinish hand(request_, ground_, trace_, progress_);
            if (hand.empty() && !progress_.cancelled())
                return Error{ErrorCode::argumentInvalid, "hand", "extend",
                             "a stroke of the hand before it in its path that has finished the part"};
            return extendedRows(trace_, hand, stepOver_, ground_.coarseness, ball, progress_);
        }
        if (request_.kind != PassKind::scallop) return rowsOf(request_, trace_.bounds(), stepOver_);
        return scallopRows(trace_, stepOver_, ground_.coarseness, ball, progress_);
    }

    /// Joins a row to the previous ones, to and fro.
    void addRow(std::vector<TipLine> row) {
        if (row.empty()) return;
        const auto distanceTo = [&](const glm::dvec3& tip) {
            return planned_.strokes.empty() ? 0.0 : glm::distance(planned_.strokes.back().back(), tip);
        };
        if (!request_.oneWay && distanceTo(row.back().back()) < distanceTo(row.front().front())) {
            std::ranges::reverse(row);
            for (TipLine& line : row) std::ranges::reverse(line);
        }
        for (TipLine& line : row) {
            if (!planned_.strokes.empty() && joins(planned_.strokes.back().back(), line.front()))
                planned_.strokes.back().insert(planned_.strokes.back().end(), line.begin(), line.end());
            else
                planned_.strokes.push_back(std::move(line));
        }
    }

    /// Joins along the part to the start of the next row, if that is no farther away than rows are apart on steep
    /// faces.
    bool joins(const glm::dvec3& from, const glm::dvec3& to) {
        const double way = glm::distance(glm::dvec2(from), glm::dvec2(to));
        if (way > 2.5 * stepOver_ || glm::distance(from, to) > 2.0 * ground_.tool.cutter.diameter) return false;
        double unused = 0.0;
        const std::vector<TipLine> intervals = trace_.along({glm::dvec2(from), glm::dvec2(to)}, unused);
        if (intervals.size() != 1 || way == 0.0) return way == 0.0;
        const TipLine& line = intervals.front();
        if (glm::distance(line.front(), from) > 0.01 || glm::distance(line.back(), to) > 0.01) return false;
        planned_.strokes.back().insert(planned_.strokes.back().end(), line.begin(), line.end());
        return true;
    }

    const PassRequest& request_;
    const PassGround& ground_;
    Progress& progress_;
    SurfaceTrace trace_;
    double stepOver_ = 0.0;
    PlannedPass planned_;
};

} // namespace

Result<PlannedPass> planRows(const PassRequest& request, const PassGround& ground, Progress& progress) {
    return RowPlanner(request, ground, progress).plan();
}

Result<PlannedPass> planRest(const PassRequest& request, const PassGround& ground, Progress& progress) {
    constexpr double steep = 45.0 * pi / 180.0, overlap = 5.0 * pi / 180.0; // rad
    PassRequest flat = request, wall = request;
    flat.kind = PassKind::parallel;
    wall.kind = PassKind::waterline;
    flat.restOnly = wall.restOnly = true;
    flat.flattest = std::max(request.flattest, 1e-6); // beside the part there is nothing to finish
    flat.steepest = std::min(request.steepest, steep + overlap);
    wall.flattest = std::max(request.flattest, steep - overlap);
    PlannedPass planned;
    const auto add = [&](const PassRequest& one, double low, double high, const auto& plan) -> Result<void> {
        if (one.flattest > one.steepest) return {};
        const ProgressPart part(progress, low, high);
        Result<PlannedPass> made = plan(one, ground, progress);
        if (!made) return std::move(made).error();
        planned.leftOut += made->leftOut;
        std::ranges::move(made->strokes, std::back_inserter(planned.strokes));
        return {};
    };
    if (Result<void> added = add(wall, 0.0, 0.5, planWaterlines); !added) return std::move(added).error();
    if (Result<void> added = add(flat, 0.5, 1.0, planRows); !added) return std::move(added).error();
    return planned;
}

Result<PlannedPass> planEngraving(const PassRequest& request, const PassGround& ground, Progress& progress) {
    const double top = request.top.value_or(ground.stock.high.z);
    double levelDepth = request.levelDepth > 0.0 ? request.levelDepth : ground.levelDepth;
    if (ground.tool.maximumDepthOfCut > 0.0) levelDepth = std::min(levelDepth, ground.tool.maximumDepthOfCut);
    const int levels = std::max(1, static_cast<int>(std::ceil(request.depth / levelDepth - depthTolerance)));
    const std::vector<RevolvedPiece> tool = pieces(ground.tool.cutter);
    const bool free = ground.part.bounds().empty();
    TipDrop drop(ground.part, tool, request.allowance, top - request.depth);
    PlannedPass planned;
    for (const PassLine& line : request.lines) {
        TipLine lowest; // where the part stops the tool, the line follows the part
        for (std::size_t i = 1; i < line.size(); ++i) {
            const glm::dvec2 from(line[i - 1]), to(line[i]);
            const int steps = free ? 1 : std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / coarsest)));
            for (int k = i == 1 ? 0 : 1; k <= steps; ++k) {
                if (progress.cancelled()) return Error{ErrorCode::cancelled, "pass", "", ""};
                const glm::dvec2 place = glm::mix(from, to, static_cast<double>(k) / steps);
                const std::optional<double> height = free ? std::nullopt : drop.at(place);
                lowest.emplace_back(place, height.value_or(top - request.depth));
            }
        }
        const bool closed = glm::distance(glm::dvec2(line.front()), glm::dvec2(line.back())) < 1e-6;
        for (int level = 1; level <= levels; ++level) {
            TipLine now = lowest;
            for (glm::dvec3& tip : now) tip.z = std::max(tip.z, top - request.depth * level / levels);
            if (!closed && level % 2 == 0) std::ranges::reverse(now);
            planned.strokes.push_back(straightened(now));
        }
    }
    return planned;
}

} // namespace burin
