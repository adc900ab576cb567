// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/thread_pass.h"

#include "core/base/numbers.h"
#include "core/base/units.h"
#include "core/geometry/upright_holes.h"
#include "core/passes/hole_order.h"
#include "core/passes/stud_thread_pass.h"
#include "core/passes/thread_size.h"
#include "core/passes/thread_stroke.h"
#include "core/passes/thread_tooth.h"
#include "core/passes/tip_drop.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>

namespace burin {

namespace {

constexpr double sameDiameter = 0.02;    // mm between the diameters of a thread and its hole
constexpr double coarsestFacets = 0.007; // mm inside of a hole's circle: the tool touches them by as much
constexpr double leastRoom = 0.05;       // mm between the tool on the axis and the core hole
constexpr double startsAbove = 1.0;      // mm above the standing stock
constexpr double undrilled = 0.15;   // mm: less stock at the bottom of a hole is ignored, as by the check of plunges
constexpr double touching = 1e-3;    // mm
constexpr double pitchesAbove = 4.0; // of a stated top above its hole, at most
constexpr double topRounding = 0.01; // mm: the limits of the top are stated in hundredths

/// A hole to thread.
struct ThreadHole {
    UprightHole hole;
    double low = 0.0, high = 0.0; ///< mm, lowest and highest tip
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
        , flutes_(flutePieces(ground.tool.cutter))
        , up_(request.leftHand == request.conventional)
        , anticlockwise_(!request.conventional) {}

    Result<PlannedPass> plan() {
        const Result<std::vector<UprightHole>> holes = requestedHoles();
        if (!holes) return holes.error();
        std::vector<glm::dvec2> places;
        for (const UprightHole& hole : *holes) places.push_back(hole.centre);
        double done = 0.0;
        for (const std::size_t i : shortestOrder(places)) {
            progress_.report(done++ / static_cast<double>(holes->size()));
            if (progress_.cancelled()) return Error{ErrorCode::cancelled, "pass", "", ""};
            if (const std::optional<ThreadHole> hole = placed((*holes)[i]))
                addThread(strokeIn(*hole), tool_, ground_.obstacles, progress_, planned_);
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
        std::vector<UprightHole> ofThread; // a narrower hole may continue below one of them
        std::ranges::copy_if(all, std::back_inserter(ofThread), [&](const auto& hole) { return isOfThread(hole); });
        for (const glm::dvec2& place : request_.places) {
            const UprightHole* around = holeAround(ofThread, place);
            if (around == nullptr) around = holeAround(all, place);
            if (around == nullptr) return wrong(place, "a round upright hole of the part");
            if (Result<void> fit = checkFit(*around, place); !fit) return fit.error();
            const auto same = [&](const UprightHole& hole) {
                return hole.centre == around->centre && hole.radius == around->radius;
            };
            if (std::ranges::none_of(wanted, same)) wanted.push_back(*around);
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
            return wrong(place, "a hole modelled with the major diameter, " + formatFixed(request_.majorDiameter, 2) +
                                    " mm, not with " + formatFixed(diameter, 2) + " mm");
        if (hole.radius - hole.clearRadius > coarsestFacets)
            return wrong(place, "a model whose facets are at most " + formatFixed(coarsestFacets, 3) +
                                    " mm inside of that hole's circle");
        if (2.0 * tooth_.radius > core - 2.0 * leastRoom)
            return wrong(place,
                         "a thread mill of at most " + formatFixed(core - 2.0 * leastRoom, 2) + " mm for that hole");
        return checkTop(hole);
    }
    /// A stated top far above a hole would make a helix without end in the air.
    Result<void> checkTop(const UprightHole& hole) const {
        const double highest = hole.top + pitchesAbove * request_.pitch;
        if (!request_.top || (*request_.top > hole.bottom && *request_.top < highest + topRounding)) return {};
        return Error{ErrorCode::argumentInvalid, "top_mm", formatShortest(*request_.top),
                     "above " + formatFixed(hole.bottom, 2) + " and at most " + formatFixed(highest, 2) +
                         " mm for the hole at " + formatFixed(hole.centre.x, 2) + ", " + formatFixed(hole.centre.y, 2)};
    }
    double helixRadius(const UprightHole& hole) const noexcept { return hole.radius - tooth_.radius; }

    /// The heights between which the tip moves in a hole; empty if it is not deep enough, which is counted.
    std::optional<ThreadHole> placed(const UprightHole& hole) {
        const double lead = 0.25 * request_.pitch, half = 0.5 * request_.pitch, top = request_.top.value_or(hole.top);
        // The lowest tip whose groove is complete at a height: behind the half turn that leads onto the helix.
        const auto tipFor = [&](double crest) { return crest - tooth_.height - lead; };
        double wanted = tipFor(hole.bottom - half), needed = tipFor(hole.bottom);
        if (request_.depth > 0.0 || request_.bottom) { // no farther than the hole
            const double stated = request_.bottom.value_or(tipFor(top - request_.depth));
            wanted = std::max(wanted, stated);
            needed = std::max(needed, stated);
        }
        const double crests = hole.top - neckLength(ground_.tool.cutter, depth_); // nothing but the tooth cuts them
        const double part = std::max(restingTip(hole, wanted, tool_), crests);
        if (part > needed + touching) { // a blind hole, or a tool that is too short
            const bool tooShort = part > restingTip(hole, wanted, flutes_) + touching;
            if (request_.depth > 0.0 || request_.bottom || tooShort) return unreached(needed);
            wanted = needed = part + pointHeight(hole);
        }
        const double stock = stockBelow(hole.centre);
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
    /// The lowest tip on an axis at which the flutes are clear of the stock, mm. Squares that the wall of the core hole
    /// may cut don't count: a hole is found too narrow if its radius is two squares less than that of the tool.
    double stockBelow(const glm::dvec2& axis) const {
        const StandingStock& standing = ground_.standing;
        if (standing.heights.empty()) return ground_.stock.high.z;
        const double edge = standing.edge, reach = tooth_.radius - std::sqrt(0.5) * edge;
        const glm::dvec2 home = glm::floor((axis - standing.low) / edge) + 0.5;
        double lowest = standing.highestIn(axis, axis);
        for (double v = -std::ceil(reach / edge); v * edge <= reach; v += 1.0)
            for (double u = -std::ceil(reach / edge); u * edge <= reach; u += 1.0) {
                const glm::dvec2 middle = standing.low + edge * (home + glm::dvec2(u, v));
                if (const double far = glm::distance(middle, axis); far <= reach)
                    lowest = std::max(lowest, standing.highestIn(middle, middle) - flutesAt(far));
            }
        return lowest;
    }
    /// The height of the flutes' lowest point above the tip at a distance from the axis, mm.
    double flutesAt(double distance) const noexcept {
        double lowest = tooth_.height;
        for (const RevolvedPiece& piece : flutes_)
            if (const std::optional<HeightRange> range = heightsAt(piece, distance))
                lowest = std::min(lowest, range->low);
        return lowest;
    }
    /// The lowest tip in the hole at which the part is clear of some pieces of the tool, at the axis and all round the
    /// helix, mm.
    double restingTip(const UprightHole& hole, double floor, std::span<const RevolvedPiece> pieces) const {
        constexpr int looks = 24;
        TipDrop drop(ground_.part, pieces, 0.0, floor);
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
        const double clear =
            std::max(ground_.stock.high.z, place.high + 0.25 * request_.pitch + tooth_.height) + startsAbove;
        ThreadStroke stroke;
        stroke.add({hole.centre, clear}, 0.0);
        const int passes = request_.radialPasses + (request_.springPass ? 1 : 0);
        for (int pass = 1; pass <= passes; ++pass) {
            const double share = std::sqrt(std::min(1.0, static_cast<double>(pass) / request_.radialPasses));
            addHelix(stroke, place, helixRadius(hole) - depth_ * (1.0 - share));
        }
        stroke.add({hole.centre, clear}, 0.0);
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
        const int arcSteps = threadSteps(pi, 0.5 * radius), steps = threadSteps(sweep, radius);
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
    /// The feed of the tool's centre on a circle, as a share of that of its cutting edge.
    double shareOf(double radius) const noexcept { return radius / (radius + tooth_.radius); }

    const PassRequest& request_;
    const PassGround& ground_;
    Progress& progress_;
    ThreadTooth tooth_;
    double depth_; ///< mm, of the thread
    std::vector<RevolvedPiece> tool_, flutes_;
    bool up_, anticlockwise_; ///< direction of the tool on the helix, seen from above
    PlannedPass planned_;
};

} // namespace

Result<PlannedPass> planThreads(const PassRequest& request, const PassGround& ground, Progress& progress) {
    if (request.external) return planStudThreads(request, ground, progress);
    const Result<ThreadTooth> tooth = threadTooth(ground.tool.cutter, request.pitch);
    if (!tooth) return tooth.error();
    return ThreadPlanner(request, ground, *tooth, progress).plan();
}

} // namespace burin
