// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/surface_trace.h"

#include "core/geometry/lowest_clear.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

constexpr double coarsestTrace = 0.2; // mm between points of a row
// mm between a row and the part's surface of tips, in the middle between two points
constexpr double chordError = 0.002;
constexpr double closest = 0.02;        // mm between points
constexpr double straightWithin = 5e-4; // mm: points this close to a straight segment are left out
constexpr double traceTolerance = 1e-6; // mm

} // namespace

SegmentShare shareWithin(const PlanBounds& bounds, const glm::dvec2& from, const glm::dvec2& to) noexcept {
    SegmentShare share;
    for (int axis = 0; axis < 2; ++axis) {
        const double way = to[axis] - from[axis];
        const double low = bounds.low[axis] - traceTolerance - from[axis];
        const double high = bounds.high[axis] + traceTolerance - from[axis];
        if (way == 0.0) {
            if (low > 0.0 || high < 0.0) return {1.0, 0.0};
            continue;
        }
        share.from = std::max(share.from, (way > 0.0 ? low : high) / way);
        share.to = std::min(share.to, (way > 0.0 ? high : low) / way);
    }
    return share;
}

bool isRest(const WorkpieceHeights& heights, const PassGround& ground, const glm::dvec3& tip) noexcept {
    const StandingStock& standing = ground.standing;
    if (!(heights.freeTip(tip.x, tip.y) > tip.z + WorkpieceHeights::leastRest)) return false;
    if (standing.thickness.empty()) return true; // nothing has been milled yet
    const double radius = ground.tool.cutter.radius();
    const glm::dvec2 middle =
        (glm::dvec2(tip) - standing.low) / standing.edge - 0.5; // in squares, from centre to centre
    const double reach = radius / standing.edge;
    const int firstRow = std::max(0, static_cast<int>(std::ceil(middle.y - reach)));
    const int lastRow = std::min(standing.rows - 1, static_cast<int>(std::floor(middle.y + reach)));
    const int firstColumn = std::max(0, static_cast<int>(std::ceil(middle.x - reach)));
    const int lastColumn = std::min(standing.columns - 1, static_cast<int>(std::floor(middle.x + reach)));
    for (int row = firstRow; row <= lastRow; ++row)
        for (int column = firstColumn; column <= lastColumn; ++column) {
            const std::size_t i = static_cast<std::size_t>(row) * static_cast<std::size_t>(standing.columns) +
                                  static_cast<std::size_t>(column);
            if (!(standing.thickness[i] > WorkpieceHeights::leastRest)) continue;
            const double distance = standing.edge * glm::distance(middle, glm::dvec2(column, row));
            if (distance <= radius &&
                standing.heights[i] > tip.z + heights.riseAt(distance) + WorkpieceHeights::leastRest)
                return true;
        }
    return false;
}

SurfaceTrace::SurfaceTrace(const PassRequest& request, const PassGround& ground)
    : request_(request)
    , ground_(ground)
    , pieces_(pieces(ground.tool.cutter))
    , heights_(ground.stock, ground.tool.cutter, ground.coarseness)
    , bottom_(request.bottom.value_or(ground.part.bounds().empty() ? ground.stock.low.z : ground.part.bounds().low.z))
    , bounds_(boundsOfRequest()) {
    heights_.lowerTo(ground.standing);
}

PlanBounds SurfaceTrace::boundsOfRequest() const {
    const double reach = ground_.tool.cutter.radius() + request_.allowance;
    if (!request_.area.empty()) {
        PlanBounds bounds = boundsOf(request_.area);
        if (request_.areaOnPart) bounds = {bounds.low - reach, bounds.high + reach};
        return bounds;
    }
    const Box part = ground_.part.bounds();
    return {glm::dvec2(part.low) - reach, glm::dvec2(part.high) + reach};
}

/// Receives points one by one, and keeps those that are requested and possible.
class SurfaceTrace::Intervals {
public:
    Intervals(const SurfaceTrace& trace, TipDrop& probe, double& leftOut)
        : trace_(trace), probe_(probe), leftOut_(leftOut) {}

    void add(const SurfacePlace& place) {
        const bool wanted = trace_.isRequested(place, probe_);
        const bool possible = wanted && trace_.isPossible(place);
        if (wanted && !possible && last_) leftOut_ += glm::distance(last_->tip, place.tip);
        if (possible && !open_) intervals_.emplace_back();
        open_ = possible;
        if (possible) intervals_.back().push_back(place.tip);
        last_ = place;
    }
    /// What follows has no connection to what came before.
    void interrupt() noexcept {
        last_.reset();
        open_ = false;
    }
    const std::optional<SurfacePlace>& last() const noexcept { return last_; }
    std::vector<TipLine> taken() {
        std::erase_if(intervals_, [](const TipLine& line) { return line.size() < 2; });
        return std::move(intervals_);
    }

private:
    const SurfaceTrace& trace_;
    TipDrop& probe_;
    double& leftOut_;
    std::vector<TipLine> intervals_;
    std::optional<SurfacePlace> last_;
    bool open_ = false;
};

std::vector<TipLine> SurfaceTrace::intervalsOf(const TipLine& line, double& leftOut) const {
    TipDrop probe = this->probe();
    Intervals intervals(*this, probe, leftOut);
    for (const glm::dvec3& tip : line) intervals.add({tip, true});
    return intervals.taken();
}

std::vector<TipLine> SurfaceTrace::along(const PlanRow& row, double& leftOut) const {
    TipDrop probe = this->probe();
    Intervals intervals(*this, probe, leftOut);
    const auto add = [&](const SurfacePlace& place) { intervals.add(place); };
    for (std::size_t i = 1; i < row.size(); ++i) {
        const SegmentShare inside = shareWithin(bounds_, row[i - 1], row[i]);
        if (inside.from != 0.0) intervals.interrupt();
        if (inside.empty()) continue;
        const glm::dvec2 from = glm::mix(row[i - 1], row[i], inside.from), to = glm::mix(row[i - 1], row[i], inside.to);
        const int steps =
            std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / (coarsestTrace * ground_.coarseness))));
        for (int k = 0; k < steps; ++k) {
            if (!intervals.last()) add(at(from, probe));
            const SurfacePlace first = *intervals.last();
            const SurfacePlace last = at(glm::mix(from, to, static_cast<double>(k + 1) / steps), probe);
            between(first, last, probe, add);
            add(last);
        }
        if (inside.to < 1.0) intervals.interrupt();
    }
    return intervals.taken();
}

/// Adds points where the segment between two deviates from the part's surface of tips.
void SurfaceTrace::between(const SurfacePlace& first, const SurfacePlace& last, TipDrop& probe,
                           const std::function<void(const SurfacePlace&)>& add) const {
    const glm::dvec2 from(first.tip), to(last.tip);
    if (glm::distance(from, to) < 2.0 * closest || (!first.onPart && !last.onPart)) return;
    const SurfacePlace middle = at(0.5 * (from + to), probe);
    const double chord = chordError * ground_.coarseness * ground_.coarseness;
    if (std::abs(middle.tip.z - 0.5 * (first.tip.z + last.tip.z)) <= chord) return;
    between(first, middle, probe, add);
    add(middle);
    between(middle, last, probe, add);
}

SurfacePlace SurfaceTrace::at(const glm::dvec2& place, TipDrop& probe) const {
    // The field leads quickly to just above the part: its clearance less its error is never more than the real one.
    const auto surelySpare = [&](double z) {
        const glm::dvec3 tip(place, z);
        return ground_.field->at(tip).clearance - ground_.field->errorBoundAt(tip) - request_.allowance;
    };
    const bool known = surelySpare(probe.top()) > 0.0;
    const double from = known ? lowestClear(surelySpare, probe.top(), bottom_).value_or(bottom_) : probe.top();
    const std::optional<double> height = probe.at(place, from);
    return {{place, height.value_or(bottom_)}, height.has_value()};
}

/// @param touch returns what the tool touches there
template <class Touch>
bool SurfaceTrace::isRequestedWith(const SurfacePlace& place, const Touch& touch) const {
    std::optional<ToolClearance> asked;
    const auto touched = [&]() -> const ToolClearance& { return asked ? *asked : asked.emplace(touch()); };
    if (!request_.area.empty()) {
        const bool byContact = request_.areaOnPart && place.onPart;
        if (!holds(request_.area, byContact ? touchedPlace(touched(), place.tip) : glm::dvec2(place.tip))) return false;
    }
    if (!place.onPart)
        return request_.flattest == 0.0 &&
               heights_.freeTip(place.tip.x, place.tip.y) > place.tip.z + WorkpieceHeights::leastRest;
    if (request_.restOnly && !isRest(heights_, ground_, place.tip)) return false;
    return !request_.limitsSlope() || request_.allowsSlope(touched().away);
}

bool SurfaceTrace::isRequested(const SurfacePlace& place, TipDrop& probe) const {
    return isRequestedWith(place, [&] { return probe.touch(place.tip); });
}

bool SurfaceTrace::isRequested(const SurfacePlace& place, const ToolClearance& touch) const {
    return isRequestedWith(place, [&] { return touch; });
}

bool SurfaceTrace::isPossible(const SurfacePlace& place) const {
    return heights_.safeHeight(place.tip) <= place.tip.z + traceTolerance &&
           heights_.freeTip(place.tip.x, place.tip.y) <=
               place.tip.z + std::min(ground_.rowDepth, usableFlutes(ground_.tool.cutter));
}

TipLine straightened(const TipLine& line) {
    if (line.size() < 3) return line;
    TipLine kept{line.front()};
    std::size_t from = 0;
    constexpr std::size_t longest = 400; // points
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

} // namespace burin
