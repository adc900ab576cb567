// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/drill_pass.h"

#include "core/base/numbers.h"
#include "core/passes/hole_order.h"
#include "core/passes/keep_clear.h"
#include "core/passes/tip_drop.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {

namespace {

constexpr double narrowest = 0.1; // mm by which a drill may be narrower than its hole
constexpr double above = 1.0;     // mm above the standing stock where a stroke begins
// mm: a smaller depth is not drilled, nor is less than a square of the stock's raster
constexpr double leastDepth = 0.05;
constexpr double rimShare = 0.05, mostRim = 0.5; // of the radius: stock that only the rim would touch is ignored
constexpr double wholeDiameters = 3.0;           // a hole no deeper than this many diameters is drilled in one peck

/// A hole to drill, mm.
struct Requested {
    glm::dvec2 place{0.0};
    double lowest = 0.0; ///< lowest position of the tip, unless the part stops it
    double top = 0.0;    ///< the tip has to come below this
};

class DrillPlanner {
public:
    DrillPlanner(const PassRequest& request, const PassGround& ground, Progress& progress)
        : request_(request)
        , ground_(ground)
        , progress_(progress)
        , tool_(pieces(ground.tool.cutter))
        , slim_(pieces(slimmer(ground.tool.cutter)))
        , heights_(ground.stock, ground.tool.cutter)
        , pointHeight_(ground.tool.cutter.radius() / std::tan(ground.tool.cutter.taperAngle)) {
        heights_.lowerTo(ground.standing);
    }

    Result<PlannedPass> plan() {
        const Result<std::vector<Requested>> wanted = wantedHoles();
        if (!wanted) return wanted.error();
        PlannedPass holes;
        for (std::size_t i = 0; i < wanted->size(); ++i) {
            progress_.report(static_cast<double>(i) / static_cast<double>(wanted->size()));
            if (progress_.cancelled()) return Error{ErrorCode::cancelled, "pass", "", ""};
            if (const std::optional<TipLine> hole = drilled((*wanted)[i])) holes.strokes.push_back(*hole);
        }
        // whole holes, as a peck must not have a piece below an obstacle
        keepClear(holes, tool_, ground_.obstacles, progress_);
        planned_.inTheWay = holes.inTheWay;
        std::vector<glm::dvec2> places;
        for (const TipLine& hole : holes.strokes) places.emplace_back(hole.front());
        for (const std::size_t i : shortestOrder(places)) addPecks(holes.strokes[i].front(), holes.strokes[i].back());
        return std::move(planned_);
    }

private:
    /// The same drill, slightly thinner and with the same point: what stops its middle stops the drill, but the wall of
    /// its hole does not.
    static Cutter slimmer(Cutter drill) {
        drill.diameter -= 2.0 * drillFit;
        return drill;
    }
    double radius() const noexcept { return ground_.tool.cutter.radius(); }

    Requested inHole(const UprightHole& hole) const {
        const double through = hole.bottom - pointHeight_ - drilledThrough;
        return {hole.centre, request_.bottom.value_or(request_.depth > 0.0 ? depthBelowTop() : through), hole.top};
    }
    double depthBelowTop() const { return request_.top.value_or(ground_.stock.high.z) - request_.depth; }

    Result<std::vector<Requested>> wantedHoles() const {
        const std::vector<UprightHole> holes = uprightHoles(ground_.part.triangles());
        std::vector<Requested> wanted;
        for (const UprightHole& hole : holes)
            if (request_.places.empty() && fitsHole(radius(), hole) &&
                (request_.area.empty() || holds(request_.area, hole.centre)))
                wanted.push_back(inHole(hole));
        for (const glm::dvec2& place : request_.places) {
            const std::string asked = formatShortest(place.x) + ", " + formatShortest(place.y);
            const UprightHole* around = holeAround(holes, place);
            if (around != nullptr && radius() > around->clearRadius + drillFit)
                return Error{ErrorCode::argumentInvalid, "places_mm", asked,
                             "a drill of at most " + formatFixed(2.0 * around->radius, 2) + " mm for that hole"};
            if (around != nullptr) {
                wanted.push_back(inHole(*around));
            } else if (request_.bottom || request_.depth > 0.0) {
                wanted.push_back({place, request_.bottom.value_or(depthBelowTop()), ground_.stock.high.z});
            } else {
                return Error{ErrorCode::argumentInvalid, "places_mm", asked,
                             "a round upright hole of the part, or a depth"};
            }
        }
        return wanted;
    }

    /// From above the standing stock to the bottom; empty if there is nothing to drill or the bottom cannot be reached.
    std::optional<TipLine> drilled(const Requested& hole) {
        const double raster = ground_.standing.heights.empty() ? 0.0 : ground_.standing.edge;
        const double rim = std::clamp(raster, rimShare * radius(), mostRim * radius());
        const double standing =
            std::min(heights_.freeTip(hole.place.x, hole.place.y, rim), request_.top.value_or(ground_.stock.high.z));
        double lowest = hole.lowest;
        if (!ground_.part.bounds().empty()) {
            TipDrop drop(ground_.part, slim_, request_.allowance, lowest);
            lowest = drop.at(hole.place).value_or(lowest);
        }
        const double flutesReach = standing - ground_.tool.cutter.fluteLength; // chips need a way out
        if (lowest < flutesReach || lowest >= hole.top) ++planned_.unreachedHoles;
        lowest = std::max(lowest, flutesReach);
        if (lowest >= hole.top || standing < lowest + std::max(leastDepth, raster)) return {};
        return TipLine{{hole.place, standing + above}, {hole.place, lowest}};
    }

    void addPecks(const glm::dvec3& top, const glm::dvec3& bottom) {
        const double depth = top.z - above - bottom.z, diameter = 2.0 * radius();
        double peck = request_.levelDepth;
        if (!(peck > 0.0)) peck = depth > wholeDiameters * diameter ? diameter : depth;
        const int count = std::max(1, static_cast<int>(std::ceil(depth / peck - 1e-9)));
        for (int i = 1; i <= count; ++i)
            planned_.strokes.push_back({top, {glm::dvec2(top), top.z - above - depth * i / count}});
    }

    const PassRequest& request_;
    const PassGround& ground_;
    Progress& progress_;
    std::vector<RevolvedPiece> tool_, slim_;
    WorkpieceHeights heights_;
    double pointHeight_; ///< mm from the tip to where the drill reaches its full diameter
    PlannedPass planned_;
};

} // namespace

bool fitsHole(double radius, const UprightHole& hole) noexcept {
    return radius <= hole.clearRadius + drillFit && 2.0 * (hole.radius - radius) <= narrowest;
}

Result<PlannedPass> planDrilling(const PassRequest& request, const PassGround& ground, Progress& progress) {
    return DrillPlanner(request, ground, progress).plan();
}

} // namespace burin
