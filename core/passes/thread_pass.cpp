// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/thread_pass.h"

#include "core/base/numbers.h"
#include "core/base/units.h"
#include "core/geometry/upright_holes.h"
#include "core/passes/hole_order.h"
#include "core/passes/keep_clear.h"
#include "core/passes/thread_size.h"
#include "core/passes/thread_tooth.h"
#include "core/passes/tip_drop.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {

namespace {

constexpr double sameDiameter = 0.02;    // mm between the diameters of a thread and its hole
constexpr double coarsestFacets = 0.007; // mm inside of a hole's circle: the tool touches them by as much
constexpr double leastRoom = 0.05;       // mm between the tool on the axis and the core hole
constexpr double helixChord = 0.0005;    // mm
constexpr double startsAbove = 1.0;      // mm above the standing stock
constexpr double undrilled = 0.05;       // mm: less stock at the bottom of a hole is ignored
constexpr double touching = 1e-3;        // mm

/// A hole to thread.
struct ThreadHole {
    UprightHole hole;
    double low = 0.0, high = 0.0; ///< mm, lowest and highest tip
};

/// A stroke with the feed of each of its points, as in PlannedPass.
struct ThreadStroke {
    TipLine tips;
    std::vector<double> shares;

    void add(const glm::dvec3& tip, double share) {
        tips.push_back(tip);
        shares.push_back(share);
    }
};

class ThreadPlanner {
public:
    ThreadPlanner(const PassRequest& request, const PassGround& ground, const ThreadTooth& tooth, Progress& progress)
        : request_(request)
        , ground_(ground)
        , progress_(progress)
        , tooth_(tooth)
        , depth_(threadDepth(request.pitch))
        , tool_(pieces(ground.tool.cutter))
        , heights_(ground.stock, ground.tool.cutter)
        , up_(request.leftHand == request.conventional)
        , anticlockwise_(!request.conventional) {
        heights_.lowerTo(ground.standing);
    }

    Result<PlannedPass> plan() {
        const Result<std::vector<UprightHole>> holes = requestedHoles();
        if (!holes) return holes.error();
        std::vector<glm::dvec2> places;
        for (const UprightHole& hole : *holes) places.push_back(hole.centre);
        double done = 0.0;
        for (const std::size_t i : shortestOrder(places)) {
            progress_.report(done++ / static_cast<double>(holes->size()));
            if (progress_.cancelled()) return Error{ErrorCode::cancelled, "pass", "", ""};
            if (const std::optional<ThreadHole> hole = placed((*holes)[i])) add(strokeIn(*hole));
        }
        return std::move(planned_);
    }

private:
    bool isOfThread(const UprightHole& hole) const noexcept {
        return std::abs(2.0 * hole.radius - request_.majorDiameter) <= sameDiameter;
    }

    Result<std::vector<UprightHole>> requestedHoles() const {
        const std::vector<UprightHole> all = uprightHoles(ground_.part.triangles());
        std::vector<UprightHole> wanted;
        if (request_.places.empty())
            for (const UprightHole& hole : all) {
                if (!isOfThread(hole) || !(request_.area.empty() || holds(request_.area, hole.centre))) continue;
                if (Result<void> fit = checkFit(hole, hole.centre); !fit) return fit.error();
                wanted.push_back(hole);
            }
        for (const glm::dvec2& place : request_.places) {
            const UprightHole* around = holeAround(all, place);
            if (around == nullptr) return wrong(place, "a round upright hole of the part");
            if (Result<void> fit = checkFit(*around, place); !fit) return fit.error();
            wanted.push_back(*around);
        }
        return wanted;
    }
    static Error wrong(const glm::dvec2& place, std::string allowed) {
        return {ErrorCode::argumentInvalid, "places_mm", formatShortest(place.x) + ", " + formatShortest(place.y),
                std::move(allowed)};
    }
    Result<void> checkFit(const UprightHole& hole, const glm::dvec2& place) const {
        const double diameter = 2.0 * hole.radius, core = diameter - 2.0 * depth_;
        if (request_.majorDiameter > 0.0 && !isOfThread(hole))
            return wrong(place, "a hole that the part has at the major diameter, " +
                                    formatFixed(request_.majorDiameter, 2) + " mm, and not at " +
                                    formatFixed(diameter, 2) + " mm");
        if (hole.radius - hole.clearRadius > coarsestFacets)
            return wrong(place, "a model whose facets are at most " + formatFixed(coarsestFacets, 3) +
                                    " mm inside of that hole's circle");
        if (2.0 * tooth_.radius > core - 2.0 * leastRoom)
            return wrong(place,
                         "a thread mill of at most " + formatFixed(core - 2.0 * leastRoom, 2) + " mm for that hole");
        return {};
    }
    double helixRadius(const UprightHole& hole) const noexcept { return hole.radius - tooth_.radius; }

    /// The heights between which the tip moves in a hole; empty if it is not deep enough, which is counted.
    std::optional<ThreadHole> placed(const UprightHole& hole) {
        const double lead = 0.25 * request_.pitch, half = 0.5 * request_.pitch, top = request_.top.value_or(hole.top);
        // The lowest tip whose groove is complete at a height: behind the half turn that leads onto the helix.
        const auto tipFor = [&](double crest) { return crest - tooth_.height - lead; };
        double wanted = tipFor(hole.bottom - half), needed = tipFor(hole.bottom);
        if (request_.depth > 0.0) wanted = needed = tipFor(top - request_.depth);
        if (request_.bottom) wanted = needed = *request_.bottom;
        const double part = restingTip(hole, wanted);
        if (part > needed + touching) { // a blind hole
            if (request_.depth > 0.0 || request_.bottom) return unreached(needed);
            needed = part + pointHeight(hole);
        }
        const double stock = heights_.freeTip(hole.centre.x, hole.centre.y, uncertainRim());
        if (stock > needed + undrilled) return unreached(needed);
        const ThreadHole found{hole, std::max({wanted, part, std::min(stock, needed)}), top + half - tooth_.height};
        return found.high - (found.low + lead) >= half ? std::optional(found) : unreached(needed);
    }
    std::nullopt_t unreached(double needed) {
        planned_.neededDrilling = planned_.unreachedHoles++ == 0 ? needed : std::min(planned_.neededDrilling, needed);
        return std::nullopt;
    }
    /// The height of the cone that a drill of 118° leaves at the bottom of the core hole, mm.
    double pointHeight(const UprightHole& hole) const noexcept {
        return (hole.radius - depth_) / std::tan(glm::radians(59.0));
    }
    /// The part of the radius that the raster of the stock may wrongly find blocked by the wall of the core hole, mm.
    double uncertainRim() const noexcept {
        const double raster = 1.5 * (ground_.standing.edge + heights_.raster());
        return std::min(raster, 0.9 * tooth_.radius);
    }
    /// The lowest tip in the hole, at the axis and all round the helix, mm.
    double restingTip(const UprightHole& hole, double floor) const {
        constexpr int looks = 24;
        TipDrop drop(ground_.part, tool_, 0.0, floor);
        double lowest = drop.at(hole.centre).value_or(floor);
        const double radius = hole.clearRadius - tooth_.radius - drillFit;
        for (int i = 0; i < looks && radius > 0.0; ++i) {
            const double angle = 2.0 * pi * i / looks;
            const glm::dvec2 place = hole.centre + radius * glm::dvec2(std::cos(angle), std::sin(angle));
            lowest = std::max(lowest, drop.at(place).value_or(floor));
        }
        return lowest;
    }

    ThreadStroke strokeIn(const ThreadHole& place) const {
        const UprightHole& hole = place.hole;
        const double above =
            std::max(ground_.stock.high.z, place.high + 0.25 * request_.pitch + tooth_.height) + startsAbove;
        ThreadStroke stroke;
        stroke.add({hole.centre, above}, 0.0);
        const int passes = request_.radialPasses + (request_.springPass ? 1 : 0);
        for (int pass = 1; pass <= passes; ++pass) {
            const double share = std::sqrt(std::min(1.0, static_cast<double>(pass) / request_.radialPasses));
            addHelix(stroke, place, helixRadius(hole) - depth_ * (1.0 - share));
        }
        stroke.add({hole.centre, above}, 0.0);
        return stroke;
    }

    /// Along the axis to the start, half a turn onto the helix, along it, and half a turn back to the axis.
    void addHelix(ThreadStroke& stroke, const ThreadHole& place, double radius) const {
        const double lead = 0.25 * request_.pitch, height = place.high - (place.low + lead);
        const double turn = anticlockwise_ ? 1.0 : -1.0, rise = up_ ? 1.0 : -1.0;
        const double begin = up_ ? place.low + lead : place.high, sweep = 2.0 * pi * height / request_.pitch;
        const glm::dvec2 centre = place.hole.centre;
        const auto at = [&](double angle, double distance) {
            return centre + distance * glm::dvec2(std::cos(angle), std::sin(angle));
        };
        stroke.add({centre, begin - rise * lead}, 0.0);
        // On a circle through the axis, the angle about the axis grows by half of that about the circle's centre.
        const double arcShare = shareOf(0.5 * radius), share = shareOf(radius);
        const int arcSteps = stepsOf(pi, 0.5 * radius), steps = stepsOf(sweep, radius);
        for (int i = 1; i <= arcSteps; ++i) {
            const double done = static_cast<double>(i) / arcSteps, angle = 0.5 * pi * (1.0 - done);
            stroke.add({at(-turn * angle, radius * std::cos(angle)), begin - rise * lead * (1.0 - done)}, arcShare);
        }
        for (int i = 1; i <= steps; ++i) {
            const double done = static_cast<double>(i) / steps;
            stroke.add({at(turn * sweep * done, radius), begin + rise * height * done}, share);
        }
        for (int i = 1; i <= arcSteps; ++i) {
            const double done = static_cast<double>(i) / arcSteps, angle = 0.5 * pi * done;
            const glm::dvec2 tip = i == arcSteps ? centre : at(turn * (sweep + angle), radius * std::cos(angle));
            stroke.add({tip, begin + rise * (height + lead * done)}, arcShare);
        }
    }
    static int stepsOf(double sweep, double radius) noexcept {
        const double step = 2.0 * std::acos(std::max(0.5, 1.0 - helixChord / radius));
        return std::max(2, static_cast<int>(std::ceil(sweep / step)));
    }
    /// The feed of the tool's centre on a circle, as a share of that of its cutting edge.
    double shareOf(double radius) const noexcept { return radius / (radius + tooth_.radius); }

    /// Adds a hole, unless anything of it comes too near to an obstacle.
    void add(ThreadStroke stroke) {
        PlannedPass alone;
        alone.strokes = {stroke.tips};
        keepClear(alone, tool_, ground_.obstacles, progress_);
        if (alone.inTheWay > 0.0) {
            planned_.inTheWay += lengthOf(stroke.tips);
            return;
        }
        planned_.strokes.push_back(std::move(stroke.tips));
        planned_.feedShares.push_back(std::move(stroke.shares));
    }

    const PassRequest& request_;
    const PassGround& ground_;
    Progress& progress_;
    ThreadTooth tooth_;
    double depth_; ///< mm, of the thread
    std::vector<RevolvedPiece> tool_;
    WorkpieceHeights heights_;
    bool up_, anticlockwise_; ///< direction of the tool on the helix, seen from above
    PlannedPass planned_;
};

} // namespace

Result<PlannedPass> planThreads(const PassRequest& request, const PassGround& ground, Progress& progress) {
    const Result<ThreadTooth> tooth = threadTooth(ground.tool.cutter, request.pitch);
    if (!tooth) return tooth.error();
    return ThreadPlanner(request, ground, *tooth, progress).plan();
}

} // namespace burin
