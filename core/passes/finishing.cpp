// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/numbers.h"
#include "core/passes/rims.h"
#include "core/passes/stroke_writer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

/// Increase of slope at one point that holds a tool which is pressed into the corner.
constexpr double kinkSlope = 0.15;
constexpr int mostRepeats = 100;       // of a pass, to and fro
constexpr double leastProgress = 0.02; // mm of depth gained by a repeat

/// A point of a pass, with the height at which the part stops the tool.
struct Touch {
    double x = 0.0;
    double reached = 0.0; ///< mm, lowest tip
};

class Finishing {
public:
    Finishing(const ClearanceField& field, const Tool& tool, const FinishingRequest& request, WorkpieceHeights& heights)
        : field_(field)
        , tool_(tool)
        , request_(request)
        , heights_(heights)
        , writer_(heights, request.speeds)
        , rims_(field, writer_.travelLevel(), request.floor)
        , sampling_(passSampling(tool.cutter)) {}

    std::vector<IntentPoint> plan() {
        const EvenPlaces rows = passesOver(request_, tool_.cutter, 1, request_.stepOver);
        bool forward = true;
        for (int i = 0; i <= rows.intervals; ++i) {
            std::vector<std::vector<Touch>> intervals = pass(rows.at(i));
            if (intervals.empty()) continue;
            if (!forward) {
                std::reverse(intervals.begin(), intervals.end());
                for (std::vector<Touch>& interval : intervals) std::reverse(interval.begin(), interval.end());
            }
            for (const std::vector<Touch>& interval : intervals) mill(interval, rows.at(i));
            forward = !forward;
        }
        writer_.finish();
        return writer_.take();
    }

private:
    double reachedAt(double x, double y) const { return rims_.reachedAt({x, y}); }

    /// The intervals of the pass at y that lie over the part or close beside it.
    std::vector<std::vector<Touch>> pass(double y) const {
        const EvenPlaces places = passesOver(request_, tool_.cutter, 0, sampling_);
        std::vector<std::vector<Touch>> intervals;
        std::vector<Touch> gap; // points on the floor since the last one near the part; crossed if the gap is short
        bool touchesPart = false;
        const std::size_t longestGap = static_cast<std::size_t>(4.0 * tool_.cutter.radius() / sampling_);
        for (int i = 0; i <= places.intervals; ++i) {
            const Touch touch{places.at(i), reachedAt(places.at(i), y)};
            const bool over = touch.reached > request_.floor + heightTolerance;
            const double beside = over ? 0.0 : field_.at({touch.x, y, request_.floor}).clearance;
            touchesPart = touchesPart || beside < request_.stepOver;
            const bool idle = request_.restOnly && !heights_.hasRest({touch.x, y, touch.reached});
            if (beside > request_.floorMargin || !std::isfinite(touch.reached) || idle) {
                gap.push_back(touch);
                continue;
            }
            if (intervals.empty() || gap.size() > longestGap)
                intervals.emplace_back();
            else
                intervals.back().insert(intervals.back().end(), gap.begin(), gap.end());
            intervals.back().push_back(touch);
            gap.clear();
        }
        if (!touchesPart) intervals.clear(); // a pass over the floor only
        for (std::vector<Touch>& interval : intervals) endBeforeRims(interval, y);
        return intervals;
    }

    /// Shortens an interval so that it ends before rims: the tool is wide enough to mill what lies at a rim from there.
    void endBeforeRims(std::vector<Touch>& interval, double y) const {
        const auto isAtRim = [&](const Touch& touch, double side) {
            return rims_.isTurnAtRim({touch.x, y}, touch.reached, {side, 0.0});
        };
        std::size_t first = 0, end = interval.size();
        while (first < end && isAtRim(interval[first], -1.0)) ++first;
        while (end > first && isAtRim(interval[end - 1], 1.0)) --end;
        if (first == end) return; // the interval is not wider than the turning distance
        interval.erase(interval.begin() + static_cast<std::ptrdiff_t>(end), interval.end());
        interval.erase(interval.begin(), interval.begin() + static_cast<std::ptrdiff_t>(first));
    }

    void mill(const std::vector<Touch>& interval, double y) {
        const glm::dvec2 start(interval.front().x, y);
        if (writer_.empty() || glm::distance(glm::dvec2(writer_.tip()), start) > 4.0 * tool_.cutter.radius())
            enter(interval, y);
        else
            cross(start);
        std::size_t held = interval.size(); // first point of an interval at which stock is left
        for (std::size_t i = 0; i < interval.size(); ++i) {
            const Touch& touch = interval[i];
            if (!std::isfinite(touch.reached)) continue;
            touchAt({touch.x, y}, touch.reached);
            if (left_ > 0.0) held = std::min(held, i);
            if (held > i || (left_ > 0.0 && i + 1 < interval.size())) continue;
            deepen(interval, y, held, i);
            held = interval.size();
        }
    }

    /// Repeats the part between two points to and fro, beginning at the second one, until all stock is removed or it
    /// gets no deeper.
    void deepen(const std::vector<Touch>& interval, double y, std::size_t first, std::size_t last) {
        double before = std::numeric_limits<double>::infinity();
        for (int i = 0; i < mostRepeats; ++i) {
            double left = 0.0;
            const auto touch = [&](const Touch& at) {
                if (!std::isfinite(at.reached)) return;
                touchAt({at.x, y}, at.reached);
                left = std::max(left, left_);
            };
            for (std::size_t k = last; k-- > first;) touch(interval[k]);
            left = 0.0;
            for (std::size_t k = first; k <= last; ++k) touch(interval[k]);
            if (left <= 0.0 || left > before - leastProgress) return;
            before = left;
        }
    }

    /// Moves from the end of one pass to the start of the next, along the surface.
    void cross(const glm::dvec2& to) {
        const glm::dvec2 from(writer_.tip());
        const int steps = static_cast<int>(std::ceil(glm::distance(from, to) / sampling_));
        for (int i = 1; i < steps; ++i) {
            const glm::dvec2 place = glm::mix(from, to, static_cast<double>(i) / steps);
            const double reached = reachedAt(place.x, place.y);
            if (std::isfinite(reached)) touchAt(place, reached);
        }
    }

    /// The lowest tip at a point, coming from the last one, that removes no more stock at once than requested.
    double lowestByStock(const glm::dvec2& place) const {
        double lowest = WorkpieceHeights::nothing;
        // beside a wall that it has cut, the raster leaves stock at the edge of the tool
        constexpr double margins = 2.5;
        const double inset = margins * trembleMargin(tool_.cutter);
        if (request_.deepest > 0.0) lowest = heights_.freeTip(place.x, place.y, inset) - request_.deepest;
        if (request_.deepestBelow > 0.0) {
            const double stock = heights_.freeTip(place.x, place.y, 0.5 * tool_.cutter.radius());
            const glm::dvec3& from = writer_.tip();
            const double way = glm::distance(place, glm::dvec2(from));
            lowest = std::max(lowest, std::min(from.z, stock - request_.deepestBelow) - rampSlope * way);
        }
        return lowest;
    }

    /// The aim of the hand at a point where the part stops the tip at `reached`.
    glm::dvec3 aimAt(const glm::dvec2& place, double reached) {
        const double pressed = reached - rims_.pressAt(place, reached, request_.press);
        // Between two points of a pass the tip rises and falls along walls, so that either height may apply.
        const double safe = heights_.safeHeight({place, pressed}, sampling_);
        heldUp_ = safe > pressed;
        return {place, safe};
    }

    /// The position at which the part holds the tip while the hand aims at `aim`: the nearest one, down the slope from
    /// `reached`.
    glm::dvec3 tipAt(const glm::dvec3& aim, double reached) const {
        if (aim.z >= reached) return aim;
        glm::dvec3 tip = aim;
        for (int i = 0; i < 3; ++i) {
            const FieldSample sample = field_.at(tip);
            const double square = glm::dot(sample.gradient, sample.gradient);
            if (!(square > 0.25)) break; // deep inside, where two faces are equally near
            tip -= sample.gradient * (sample.clearance / square);
        }
        const bool found =
            std::abs(field_.at(tip).clearance) < surfaceTolerance && glm::distance(tip, aim) <= reached - aim.z;
        return found ? tip : glm::dvec3(aim.x, aim.y, reached);
    }

    /// Comes down at the first point of an interval. If stock stands there, goes down a ramp over the following points
    /// and back over the ground that it cut.
    void enter(const std::vector<Touch>& interval, double y) {
        const glm::dvec2 start(interval.front().x, y);
        climbing_ = false;
        slope_ = 0.0;
        const double reached = reached_ = interval.front().reached;
        aim_ = aimAt(start, reached);
        const double depth = writer_.depthAt(tipAt(aim_, reached));
        if (depth <= plungeDepth) {
            writer_.enterAt(aim_, tipAt(aim_, reached));
            return;
        }
        double height = tipAt(aim_, reached).z + depth;
        aim_ = {start, height};
        writer_.enterAt(aim_, aim_);
        std::size_t end = 0;
        for (std::size_t i = 1; i < interval.size() && std::isfinite(interval[i].reached); ++i) {
            const Touch& touch = interval[i];
            if (touch.reached > height) break; // a wall
            height -= rampSlope * std::abs(touch.x - interval[i - 1].x);
            const bool down = height <= touch.reached;
            const glm::dvec3 ground = aimAt({touch.x, y}, touch.reached);
            aim_ = {touch.x, y, std::max({height, touch.reached, ground.z})};
            writer_.cutTo(aim_);
            reached_ = touch.reached;
            end = i;
            if (down) break;
        }
        while (end-- > 0) touchAt({interval[end].x, y}, interval[end].reached);
    }

    /// Goes slowly over the rim of a wall that it climbed, or over what held it in a corner: a hand rounds its corners.
    void goOverRim(const glm::dvec2& place, double reached) {
        aim_.z = std::max({aim_.z, reached_ + overRim, reached + overRim});
        writer_.cutTo(aim_);
        aim_ = {place, aim_.z};
        writer_.creepTo(aim_);
    }

    void touchAt(const glm::dvec2& place, double reached) {
        const double slope = (reached - reached_) / std::max(1e-6, glm::distance(place, glm::dvec2(aim_)));
        const bool climbs = rims_.isWall(glm::dvec2(aim_), reached_, place, reached) ||
                            (slope - slope_ > kinkSlope && reached - reached_ > heightTolerance);
        if (climbing_ && !climbs) goOverRim(place, reached);
        climbing_ = climbs;
        slope_ = slope;
        reached_ = reached;
        const glm::dvec3 from = aim_;
        const bool wasHeldUp = heldUp_;
        const double byStock = lowestByStock(place);
        left_ = byStock > reached + heightTolerance ? byStock - reached : 0.0;
        aim_ = aimAt(place, reached);
        if (left_ > 0.0) aim_.z = std::max(aim_.z, byStock);
        heldUp_ = heldUp_ || (left_ > 0.0 && aim_.z > from.z);
        // Where standing stock keeps the shank up, the tool rises before that point and descends after it.
        if (heldUp_ && aim_.z > from.z)
            writer_.cutTo({from.x, from.y, aim_.z}, liftedTo(aim_.z));
        else if (wasHeldUp && aim_.z < from.z)
            writer_.cutTo({place, from.z}, tipAt({place, from.z}, reached));
        writer_.cutTo(aim_, tipAt(aim_, reached));
    }

    glm::dvec3 liftedTo(double height) const {
        const glm::dvec3& tip = writer_.tip();
        return {tip.x, tip.y, std::max(tip.z, height)};
    }

    const ClearanceField& field_;
    const Tool& tool_;
    FinishingRequest request_;
    WorkpieceHeights& heights_;
    StrokeWriter writer_;
    OperatorRims rims_;
    double sampling_;      ///< mm along a pass
    glm::dvec3 aim_{0.0};  ///< of the last stroke
    double reached_ = 0.0; ///< mm, height at which the part stops the tool at the last point
    double slope_ = 0.0;   ///< slope of what stops it, on the way to that point
    double left_ = 0.0; ///< mm of stock that remains at the last point because more stood there than is removed at once
    bool heldUp_ = false;   ///< it was kept above the height to which the hand would have pressed
    bool climbing_ = false; ///< the last point is higher than the one before it, behind a wall or corner
};

} // namespace

Result<void> checkFinishing(const Tool& tool, const FinishingRequest& request) {
    if (Result<void> valid = checkSpeeds(request.speeds); !valid) return valid.error();
    const Cutter& cutter = tool.cutter;
    if (Result<void> valid = checkAbove({{"cutter diameter", cutter.diameter}, {"flute length", cutter.fluteLength}});
        !valid)
        return valid.error();
    if (Result<void> valid = checkNotBelow({{"step-over", request.stepOver},
                                            {"crosswise step-over", request.crosswiseStepOver},
                                            {"press", request.press},
                                            {"floor margin", request.floorMargin},
                                            {"deepest", request.deepest},
                                            {"deepest below", request.deepestBelow}});
        !valid)
        return valid.error();
    if (request.part.empty() || !isFinite(request.part.size()) || !std::isfinite(request.floor))
        return Error{ErrorCode::argumentInvalid, "part", "", "a box that is not empty, and a finite floor"};
    return {};
}

FinishingRequest withStepOvers(FinishingRequest request, const Cutter& cutter) {
    if (request.stepOver <= 0.0) request.stepOver = cutter.diameter / 15.0;
    if (request.crosswiseStepOver <= 0.0) request.crosswiseStepOver = 1.5 * request.stepOver;
    return request;
}

Result<std::vector<IntentPoint>> planFinishing(const ClearanceField& field, const Tool& tool,
                                               const FinishingRequest& request, WorkpieceHeights& heights) {
    if (Result<void> valid = checkFinishing(tool, request); !valid) return valid.error();
    return Finishing(field, tool, withStepOvers(request, tool.cutter), heights).plan();
}

} // namespace burin
