// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"
#include "core/base/parallel_progress.h"
#include "core/passes/level_order.h"
#include "core/passes/surface_pass.h"
#include "core/passes/tip_drop.h"
#include "core/passes/tip_raster.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

constexpr double contourChord = 0.002;    // mm between a contour and the surface of tips
constexpr double contourPrecision = 1e-4; // mm of clearance
constexpr double closestPlaces = 0.02;    // mm
// horizontal component of the unit vector out of the part: flatter faces have no usable contour
constexpr double leastSidewards = 0.05;
constexpr double coarsestRaster = 0.5; // mm
constexpr double beside = 1.0;         // mm beside the part in which contours are searched

/// The contour of the surface of tips at one height, exact on the part's triangles. Not thread-safe.
class ExactContour {
public:
    ExactContour(const MeshDistance& part, std::span<const RevolvedPiece> tool, double allowance, double height)
        : asker_(part, tool), allowance_(allowance), height_(height) {}

    /// The ring with its points moved onto the contour, and further points where it bends. An empty entry stands for a
    /// point without a contour nearby: the tool cannot pass it.
    std::vector<std::optional<glm::dvec2>> along(const PlanRing& ring) {
        std::vector<std::optional<glm::dvec2>> exact;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const std::optional<glm::dvec2> from = onContour(ring[i]);
            const std::optional<glm::dvec2> to = onContour(ring[(i + 1) % ring.size()]);
            exact.push_back(from);
            if (from && to) between(*from, *to, exact);
        }
        return exact;
    }
    /// What the tool touches at a point.
    ToolClearance touch(const glm::dvec2& place) {
        return asker_.ask({place.x, place.y, height_}, allowance_ + 10.0, {});
    }

private:
    std::optional<glm::dvec2> onContour(glm::dvec2 place) {
        constexpr int attempts = 12;
        for (int i = 0; i < attempts; ++i) {
            const ToolClearance now = touch(place);
            const double missing = allowance_ - now.clearance;
            if (std::abs(missing) <= contourPrecision) return place;
            const glm::dvec2 out(now.away);
            const double sidewards = glm::length(out);
            if (sidewards < leastSidewards) return {};
            place += out * (missing / (sidewards * sidewards));
        }
        return {};
    }

    void between(const glm::dvec2& from, const glm::dvec2& to, std::vector<std::optional<glm::dvec2>>& exact) {
        if (glm::distance(from, to) < 2.0 * closestPlaces) return;
        const glm::dvec2 middle = 0.5 * (from + to);
        const std::optional<glm::dvec2> moved = onContour(middle);
        if (!moved || glm::distance(*moved, middle) <= contourChord ||
            glm::distance(*moved, middle) > 0.5 * glm::distance(from, to))
            return;
        between(from, *moved, exact);
        exact.push_back(*moved);
        between(*moved, to, exact);
    }

    ClearanceAsker asker_;
    double allowance_, height_;
};

class WaterlinePlanner {
public:
    WaterlinePlanner(const PassRequest& request, const PassGround& ground, Progress& progress)
        : request_(request)
        , ground_(ground)
        , progress_(progress)
        , pieces_(pieces(ground.tool.cutter))
        , heights_(ground.stock, ground.tool.cutter, ground.coarseness) {
        heights_.lowerTo(ground.standing);
    }

    Result<PlannedPass> plan() {
        const Box part = ground_.part.bounds();
        if (part.empty())
            return Error{ErrorCode::argumentInvalid, "pass", std::string(rowOf(request_.kind).id),
                         "a part to go along; there is none"};
        const Result<double> step = stepOverOf(request_, ground_.tool.cutter);
        if (!step) return step.error();
        step_ = *step * ground_.coarseness;
        const double top = std::min(request_.top.value_or(part.high.z), part.high.z);
        const double bottom = request_.bottom.value_or(part.low.z);
        if (!(bottom < top)) return PlannedPass{};
        const int count = std::max(1, static_cast<int>(std::ceil((top - bottom) / step_ - 1e-9)));
        const double reach = ground_.tool.cutter.radius() + request_.allowance + beside;
        const TipRaster raster(*ground_.field, {glm::dvec2(part.low) - reach, glm::dvec2(part.high) + reach},
                               ground_.coarseness * std::min(coarsestRaster, ground_.tool.cutter.radius() / 4.0),
                               request_.allowance, part.high.z + request_.allowance + 1.0, bottom, progress_);
        std::vector<std::vector<LevelRun>> levels(static_cast<std::size_t>(count));
        std::vector<double> leftOut(levels.size(), 0.0);
        ParallelProgress done(progress_, levels.size());
        parallelFor(std::size_t{0}, levels.size(), [&](std::size_t i) {
            if (progress_.cancelled()) return;
            const double height = top + (bottom - top) * static_cast<double>(i + 1) / count;
            levels[i] = runsAt(raster, height, leftOut[i]);
            done.add();
        });
        if (progress_.cancelled()) return Error{ErrorCode::cancelled, "pass", "", ""};
        for (const double one : leftOut) planned_.leftOut += one;
        order(levels, top, (top - bottom) / count);
        return std::move(planned_);
    }

private:
    std::vector<LevelRun> runsAt(const TipRaster& raster, double height, double& leftOut) const {
        ExactContour contour(ground_.part, pieces_, request_.allowance, height);
        std::vector<LevelRun> runs;
        for (PlanRing ring : raster.blockedAt(height).rings) {
            std::ranges::reverse(ring); // the free region to the left, so that it climbs
            std::vector<glm::dvec2> places;
            std::vector<LevelPlace> work;
            bool breaksAtEnd = false;
            for (const std::optional<glm::dvec2>& place : contour.along(ring)) {
                if (!place) { // the tool cannot pass it
                    if (work.empty())
                        breaksAtEnd = true;
                    else
                        work.back() = LevelPlace::forbidden;
                    continue;
                }
                places.push_back(*place);
                work.push_back(isRequested(*place, height, contour) ? LevelPlace::cuts : LevelPlace::forbidden);
                if (work.back() == LevelPlace::cuts && !isPossible({*place, height})) {
                    work.back() = LevelPlace::forbidden;
                    if (places.size() > 1) leftOut += glm::distance(places.back(), places[places.size() - 2]);
                }
            }
            if (places.size() < 3) continue;
            if (breaksAtEnd) work.back() = LevelPlace::forbidden;
            for (LevelRun& run : runsAlong(places, std::move(work), 0)) runs.push_back(std::move(run));
        }
        return runs;
    }

    bool isRequested(const glm::dvec2& place, double height, ExactContour& contour) const {
        if (!isInArea(place, height, contour)) return false;
        if (request_.restOnly && !isRest(heights_, ground_, {place, height})) return false;
        return !request_.limitsSlope() || request_.allowsSlope(contour.touch(place).away);
    }
    bool isInArea(const glm::dvec2& place, double height, ExactContour& contour) const {
        if (request_.area.empty()) return true;
        const glm::dvec2 meant =
            request_.areaOnPart ? touchedPlace(contour.touch(place), glm::dvec3(place, height)) : place;
        return holds(request_.area, meant);
    }
    bool isPossible(const glm::dvec3& tip) const {
        return heights_.safeHeight(tip) <= tip.z + 1e-6 &&
               heights_.freeTip(tip.x, tip.y, 0.5 * ground_.tool.cutter.radius()) <=
                   tip.z + usableFlutes(ground_.tool.cutter);
    }

    /// Goes down along a wall as long as the next contour is near, then continues with the highest one left.
    void order(std::vector<std::vector<LevelRun>>& levels, double top, double step) {
        std::optional<glm::dvec2> tip;
        std::size_t level = 0, first = 0;
        while (true) {
            while (first < levels.size() && levels[first].empty()) ++first;
            if (first == levels.size()) return;
            const bool below = tip && level + 1 < levels.size() && distanceTo(levels[level + 1], *tip) <= nearBelow();
            level = below ? level + 1 : first;
            std::vector<LevelRun>& runs = levels[level];
            const std::size_t next = nearest(runs, tip);
            add(begun(std::move(runs[next]), tip), top - step * static_cast<double>(level + 1), below);
            runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(next));
            tip = glm::dvec2(planned_.strokes.back().back());
        }
    }
    double nearBelow() const { return 3.0 * step_ + 0.5; } // mm in plan: a wall of 15 degrees or steeper

    static double distanceTo(const LevelRun& run, const glm::dvec2& tip) {
        if (!run.closed) return glm::distance(run.places.front(), tip);
        double least = 1e300;
        for (const glm::dvec2& place : run.places) least = std::min(least, glm::distance(place, tip));
        return least;
    }
    static double distanceTo(const std::vector<LevelRun>& runs, const glm::dvec2& tip) {
        double least = 1e300;
        for (const LevelRun& run : runs) least = std::min(least, distanceTo(run, tip));
        return least;
    }
    static std::size_t nearest(const std::vector<LevelRun>& runs, const std::optional<glm::dvec2>& tip) {
        if (!tip) return 0;
        return static_cast<std::size_t>(
            std::ranges::min_element(runs, {}, [&](const LevelRun& run) { return distanceTo(run, *tip); }) -
            runs.begin());
    }
    static LevelRun begun(LevelRun run, const std::optional<glm::dvec2>& tip) {
        if (!run.closed || !tip) return run;
        const auto start = std::ranges::min_element(
            run.places, {}, [&](const glm::dvec2& place) { return glm::distance(place, *tip); });
        return begunAt(std::move(run), static_cast<std::size_t>(start - run.places.begin()));
    }

    void add(const LevelRun& run, double height, bool goesOn) {
        const glm::dvec3 start(run.places.front(), height);
        if (!goesOn || planned_.strokes.empty() || !mayGo(planned_.strokes.back().back(), start))
            planned_.strokes.emplace_back();
        for (const glm::dvec2& place : run.places) planned_.strokes.back().emplace_back(place, height);
    }

    /// Whether the straight move down from one contour to the next is short and keeps clear of the part.
    bool mayGo(const glm::dvec3& from, const glm::dvec3& to) const {
        constexpr double looks = 0.1; // mm
        const double length = glm::distance(from, to);
        if (length > 3.0 * step_ + 0.5) return false;
        const int steps = static_cast<int>(std::ceil(length / looks));
        for (int i = 1; i < steps; ++i) {
            const ToolPose pose{glm::mix(from, to, static_cast<double>(i) / steps), {0.0, 0.0, 1.0}};
            if (ground_.part.clearance(pieces_, pose, request_.allowance + 1.0).clearance <
                request_.allowance - contourChord)
                return false;
        }
        return true;
    }

    const PassRequest& request_;
    const PassGround& ground_;
    Progress& progress_;
    std::vector<RevolvedPiece> pieces_;
    WorkpieceHeights heights_;
    double step_ = 0.0;
    PlannedPass planned_;
};

} // namespace

Result<PlannedPass> planWaterlines(const PassRequest& request, const PassGround& ground, Progress& progress) {
    return WaterlinePlanner(request, ground, progress).plan();
}

} // namespace burin
