// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/rims.h"
#include "core/passes/stroke_writer.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {

namespace {

constexpr double steepSlope = 1.0;          // 45 degrees across the rows
constexpr double shortestInterval = 1.0;    // mm: shorter intervals lie between two rows
constexpr double longestCrosswiseGap = 1.0; // mm along a pass that is milled through rather than around

/// The aim of the hand, and the position at which the part then holds the tip.
struct CrosswiseTouch {
    glm::dvec3 aim{0.0}, tip{0.0};
};

/// The interval that a pass mills in one go: a wall from its foot to its rim, or the reverse.
struct Interval {
    std::vector<CrosswiseTouch> touches;
    bool done = false;
};

class Crosswise {
public:
    Crosswise(const ClearanceField& field, const Tool& tool, const FinishingRequest& request, WorkpieceHeights& heights)
        : field_(field)
        , tool_(tool)
        , request_(request)
        , heights_(heights)
        , writer_(heights, request.speeds)
        , sampling_(passSampling(tool.cutter)) {}

    std::vector<IntentPoint> plan() {
        const EvenPlaces passes = passesOver(request_, tool_.cutter, 0, request_.crosswiseStepOver);
        for (int i = 0; i <= passes.intervals; ++i) passes_.push_back(steepIntervals(passes.at(i)));
        for (std::size_t i = 0; i < passes_.size(); ++i)
            for (Interval& interval : passes_[i])
                if (!interval.done) millFrom(i, interval);
        writer_.finish();
        return writer_.take();
    }

private:
    /// The intervals of the pass at x on which neighbouring rows lie far apart.
    std::vector<Interval> steepIntervals(double x) const {
        const EvenPlaces rows = passesOver(request_, tool_.cutter, 1, request_.stepOver);
        std::vector<Interval> intervals;
        glm::dvec3 before = reachedAt(x, rows.low);
        double gap = 0.0; // mm since the last steep point
        bool open = false;
        for (int row = 1; row <= rows.intervals; ++row) {
            const glm::dvec3 now = reachedAt(x, rows.at(row));
            const double way = now.y - before.y;
            const bool known = std::isfinite(now.z) && std::isfinite(before.z);
            const bool steep = known && std::abs(now.z - before.z) > steepSlope * way;
            gap = steep ? 0.0 : gap + way;
            open = open && known && gap <= longestCrosswiseGap;
            if (steep && !open) {
                intervals.emplace_back();
                open = true;
            }
            if (open) open = follow(before, now, intervals.back());
            before = now;
        }
        std::erase_if(intervals, [](const Interval& interval) {
            return interval.touches.empty() ||
                   glm::distance(interval.touches.front().tip, interval.touches.back().tip) < shortestInterval;
        });
        return intervals;
    }

    glm::dvec3 reachedAt(double x, double y) const {
        return {x, y, lowestFeasibleHeight(field_, x, y, 0.0, writer_.travelLevel(), request_.floor)};
    }

    /// Adds touches on the surface between two of its points; false where the tool can't continue.
    bool follow(const glm::dvec3& from, const glm::dvec3& to, Interval& interval) const {
        const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / sampling_)));
        for (int i = interval.touches.empty() ? 0 : 1; i <= steps; ++i) {
            const std::optional<CrosswiseTouch> touch = touchNear(glm::mix(from, to, static_cast<double>(i) / steps));
            if (!touch) continue; // an edge, where no single face is the nearest
            // Standing stock beside the wall: the shank must not reach it.
            if (heights_.safeHeight(touch->tip, sampling_) > touch->tip.z + heightTolerance) return false;
            interval.touches.push_back(*touch);
        }
        return true;
    }

    /// The hand presses at right angles to the surface: straight down it would hardly press on a wall at all.
    std::optional<CrosswiseTouch> touchNear(const glm::dvec3& place) const {
        glm::dvec3 tip = place, normal(0.0);
        for (int i = 0; i < 3; ++i) {
            const FieldSample sample = field_.at(tip);
            const double slope = glm::length(sample.gradient);
            if (!(slope > 0.5)) return std::nullopt;
            normal = sample.gradient / slope;
            tip -= normal * (sample.clearance / slope);
        }
        tip.z = std::max(tip.z, request_.floor);
        // At the rim of a wall, the top would hold the tool while the hand goes down behind it.
        if (field_.at(tip + overRim * (glm::dvec3(0.0, 0.0, 1.0) - normal)).clearance > 0.0) return std::nullopt;
        if (!(std::abs(field_.at(tip).clearance) < surfaceTolerance)) return std::nullopt;
        CrosswiseTouch touch{tip - request_.press * normal, tip};
        touch.aim.z = std::max(touch.aim.z, request_.floor);
        return touch;
    }

    /// Mills an interval and those that adjoin it in the following passes: to and fro along one wall.
    void millFrom(std::size_t pass, Interval& first) {
        mill(first);
        for (std::size_t i = pass + 1; i < passes_.size(); ++i) {
            Interval* next = nearest(passes_[i]);
            if (next == nullptr) return;
            mill(*next);
        }
    }

    /// The interval of a pass that begins close to the tip; null if there is none.
    Interval* nearest(std::vector<Interval>& pass) const {
        Interval* best = nullptr;
        double least = 2.0 * tool_.cutter.radius();
        for (Interval& interval : pass) {
            if (interval.done) continue;
            const double distance = distanceTo(interval);
            if (distance >= least) continue;
            least = distance;
            best = &interval;
        }
        return best;
    }

    double distanceTo(const Interval& interval) const {
        return std::min(glm::distance(writer_.tip(), interval.touches.front().tip),
                        glm::distance(writer_.tip(), interval.touches.back().tip));
    }

    void mill(Interval& interval) {
        std::vector<CrosswiseTouch>& touches = interval.touches;
        const bool joins = !writer_.empty() && distanceTo(interval) < 2.0 * tool_.cutter.radius();
        if (joins &&
            glm::distance(writer_.tip(), touches.back().tip) < glm::distance(writer_.tip(), touches.front().tip))
            std::reverse(touches.begin(), touches.end());
        if (joins)
            cross(touches.front());
        else
            enter(touches.front());
        for (const CrosswiseTouch& touch : touches) writer_.cutTo(touch.aim, touch.tip);
        interval.done = true;
    }

    /// Comes down beside the wall, not into it.
    void enter(const CrosswiseTouch& touch) { writer_.enterAt(touch.tip, touch.tip); }

    /// Moves from the end of one interval to the start of the next, along the surface.
    void cross(const CrosswiseTouch& to) {
        const glm::dvec3 from = writer_.tip();
        const int steps = static_cast<int>(std::ceil(glm::distance(from, to.tip) / sampling_));
        for (int i = 1; i < steps; ++i) {
            const std::optional<CrosswiseTouch> touch =
                touchNear(glm::mix(from, to.tip, static_cast<double>(i) / steps));
            if (touch && heights_.safeHeight(touch->tip, sampling_) <= touch->tip.z + heightTolerance)
                writer_.cutTo(touch->aim, touch->tip);
        }
    }

    const ClearanceField& field_;
    const Tool& tool_;
    const FinishingRequest& request_;
    WorkpieceHeights& heights_;
    StrokeWriter writer_;
    std::vector<std::vector<Interval>> passes_;
    double sampling_; ///< mm along a pass
};

} // namespace

Result<std::vector<IntentPoint>> planCrosswiseFinishing(const ClearanceField& field, const Tool& tool,
                                                        const FinishingRequest& request, WorkpieceHeights& heights) {
    if (Result<void> valid = checkFinishing(tool, request); !valid) return valid.error();
    const FinishingRequest wanted = withStepOvers(request, tool.cutter);
    return Crosswise(field, tool, wanted, heights).plan();
}

} // namespace burin
