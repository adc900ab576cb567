// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/surface_pass.h"

#include "core/base/parallel.h"
#include "core/base/parallel_progress.h"
#include "core/geometry/lowest_clear.h"
#include "core/passes/tip_drop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace burin {
namespace {

constexpr double coarsest = 0.2;        // mm between places of a row
constexpr double chordError = 0.002;    // mm between a row and the part's surface of tips, at the middle of two places
constexpr double closest = 0.02;        // mm between places
constexpr double straightWithin = 5e-4; // mm: places that a straight way passes as near as that are left out
constexpr double tolerance = 1e-6;      // mm

/// A place of a row.
struct RowPlace {
    glm::dvec3 tip{0.0};
    bool onPart = false;
};

/// Leaves out what lies on the straight way between its neighbours.
TipLine straightened(const TipLine& line) {
    if (line.size() < 3) return line;
    TipLine kept{line.front()};
    std::size_t from = 0;
    constexpr std::size_t longest = 400; // places
    for (std::size_t i = 2; i < line.size(); ++i) {
        const glm::dvec3 along = line[i] - line[from];
        const double length = glm::length(along);
        bool straight = length > 0.0 && i - from < longest;
        for (std::size_t k = from + 1; k < i && straight; ++k)
            straight = glm::length(glm::cross(line[k] - line[from], along)) <= straightWithin * length;
        if (straight) continue;
        from = i - 1;
        kept.push_back(line[from]);
    }
    kept.push_back(line.back());
    return kept;
}

class RowPlanner {
public:
    RowPlanner(const PassRequest& request, const PassGround& ground, Progress& progress)
        : request_(request)
        , ground_(ground)
        , progress_(progress)
        , pieces_(pieces(ground.tool.cutter))
        , heights_(ground.stock, ground.tool.cutter)
        , bottom_(
              request.bottom.value_or(ground.part.bounds().empty() ? ground.stock.low.z : ground.part.bounds().low.z)) {
        heights_.lowerTo(ground.standing);
    }

    Result<PlannedPass> plan() {
        if (ground_.part.bounds().empty())
            return Error{ErrorCode::argumentInvalid, "pass", std::string(rowOf(request_.kind).id),
                         "a part to lay rows on; there is none"};
        const Result<double> stepOver = stepOverOf(request_, ground_.tool.cutter);
        if (!stepOver) return stepOver.error();
        stepOver_ = *stepOver;
        const std::vector<PlanRow> rows = rowsOf(request_, bounds(), stepOver_);
        std::vector<std::vector<TipLine>> stretches(rows.size());
        std::vector<double> leftOut(rows.size(), 0.0);
        ParallelProgress done(progress_, rows.size());
        parallelFor(std::size_t{0}, rows.size(), [&](std::size_t i) {
            if (progress_.cancelled()) return;
            stretches[i] = stretchesOf(rows[i], leftOut[i]);
            done.add();
        });
        if (progress_.cancelled()) return Error{ErrorCode::cancelled, "pass", "", ""};
        for (const double one : leftOut) planned_.leftOut += one;
        for (std::vector<TipLine>& row : stretches) addRow(std::move(row));
        for (TipLine& stroke : planned_.strokes) stroke = straightened(stroke);
        return std::move(planned_);
    }

private:
    /// Over the area, or the part and as far beside it as the tool touches it.
    PlanBounds bounds() const {
        if (!request_.area.empty()) return boundsOf(request_.area);
        const Box part = ground_.part.bounds();
        const double reach = ground_.tool.cutter.radius();
        return {glm::dvec2(part.low) - reach, glm::dvec2(part.high) + reach};
    }

    std::vector<TipLine> stretchesOf(const PlanRow& row, double& leftOut) const {
        TipDrop drop(ground_.part, pieces_, request_.allowance, bottom_);
        std::vector<TipLine> stretches;
        bool open = false;
        std::optional<RowPlace> before;
        const auto add = [&](const RowPlace& place) {
            const bool wanted = isWanted(place, drop);
            const bool possible = wanted && isPossible(place);
            if (wanted && !possible && before) leftOut += glm::distance(before->tip, place.tip);
            if (possible && !open) stretches.emplace_back();
            open = possible;
            if (possible) stretches.back().push_back(place.tip);
            before = place;
        };
        for (std::size_t i = 1; i < row.size(); ++i) {
            const glm::dvec2 &from = row[i - 1], &to = row[i];
            const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / coarsest)));
            for (int k = 0; k < steps; ++k) {
                const RowPlace first = before ? *before : placeAt(from, drop);
                if (!before) add(first);
                const RowPlace last = placeAt(glm::mix(from, to, static_cast<double>(k + 1) / steps), drop);
                between(first, last, drop, add);
                add(last);
            }
        }
        std::erase_if(stretches, [](const TipLine& line) { return line.size() < 2; });
        return stretches;
    }

    /// Adds places where the straight way between two leaves the part's surface of tips.
    template <class Add>
    void between(const RowPlace& first, const RowPlace& last, TipDrop& drop, const Add& add) const {
        const glm::dvec2 from(first.tip), to(last.tip);
        if (glm::distance(from, to) < 2.0 * closest || (!first.onPart && !last.onPart)) return;
        const RowPlace middle = placeAt(0.5 * (from + to), drop);
        if (std::abs(middle.tip.z - 0.5 * (first.tip.z + last.tip.z)) <= chordError) return;
        between(first, middle, drop, add);
        add(middle);
        between(middle, last, drop, add);
    }

    RowPlace placeAt(const glm::dvec2& place, TipDrop& drop) const {
        // The field leads quickly to just above: what it says, less its error there, is never more than there is.
        const auto surelySpare = [&](double z) {
            const glm::dvec3 tip(place, z);
            return ground_.field.at(tip).clearance - ground_.field.errorBoundAt(tip) - request_.allowance;
        };
        const bool known = surelySpare(drop.top()) > 0.0;
        const double from = known ? lowestClear(surelySpare, drop.top(), bottom_).value_or(bottom_) : drop.top();
        const std::optional<double> height = drop.at(place, from);
        return {{place, height.value_or(bottom_)}, height.has_value()};
    }

    bool isWanted(const RowPlace& place, TipDrop& drop) const {
        if (!request_.area.empty() && !holds(request_.area, glm::dvec2(place.tip))) return false;
        const bool rest = heights_.freeTip(place.tip.x, place.tip.y) > place.tip.z + WorkpieceHeights::leastRest;
        if (!place.onPart || request_.restOnly) {
            if (!rest) return false;
            if (!place.onPart) return request_.flattest == 0.0;
        }
        return !request_.limitsSlope() || request_.allowsSlope(drop.away(place.tip));
    }

    /// Whether nothing but the flutes meets stock, and these no more than they bear.
    bool isPossible(const RowPlace& place) const {
        return heights_.safeHeight(place.tip) <= place.tip.z + tolerance &&
               heights_.freeTip(place.tip.x, place.tip.y) <=
                   place.tip.z + std::min(ground_.rowDepth, usableFlutes(ground_.tool.cutter));
    }
    /// Joins a row to the ones before it, there and back.
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

    /// Goes on the part to where the next row begins, if that is no farther than rows are apart where it is steep.
    bool joins(const glm::dvec3& from, const glm::dvec3& to) {
        const double way = glm::distance(glm::dvec2(from), glm::dvec2(to));
        if (way > 2.5 * stepOver_ || glm::distance(from, to) > 2.0 * ground_.tool.cutter.diameter) return false;
        double unused = 0.0;
        const std::vector<TipLine> stretches = stretchesOf({glm::dvec2(from), glm::dvec2(to)}, unused);
        if (stretches.size() != 1 || way == 0.0) return way == 0.0;
        const TipLine& line = stretches.front();
        if (glm::distance(line.front(), from) > 0.01 || glm::distance(line.back(), to) > 0.01) return false;
        planned_.strokes.back().insert(planned_.strokes.back().end(), line.begin(), line.end());
        return true;
    }

    const PassRequest& request_;
    const PassGround& ground_;
    Progress& progress_;
    std::vector<RevolvedPiece> pieces_;
    WorkpieceHeights heights_;
    double bottom_, stepOver_ = 0.0;
    PlannedPass planned_;
};

} // namespace

Result<PlannedPass> planRows(const PassRequest& request, const PassGround& ground, Progress& progress) {
    return RowPlanner(request, ground, progress).plan();
}

Result<PlannedPass> planEngraving(const PassRequest& request, const PassGround& ground, Progress& progress) {
    const double top = request.top.value_or(ground.stock.high.z);
    double levelDepth = request.levelDepth > 0.0 ? request.levelDepth : ground.levelDepth;
    if (ground.tool.maximumDepthOfCut > 0.0) levelDepth = std::min(levelDepth, ground.tool.maximumDepthOfCut);
    const int levels = std::max(1, static_cast<int>(std::ceil(request.depth / levelDepth - tolerance)));
    const std::vector<RevolvedPiece> tool = pieces(ground.tool.cutter);
    const bool free = ground.part.bounds().empty();
    TipDrop drop(ground.part, tool, request.allowance, top - request.depth);
    PlannedPass planned;
    for (const PassLine& line : request.lines) {
        TipLine lowest; // where the part holds the tool up it goes on the part
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
