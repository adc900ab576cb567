// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/stroke_writer.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {
constexpr double approach = 1.0;    // mm above stock at which the descent becomes slow
constexpr double longestLeg = 30.0; // mm of a ramp
constexpr int mostTurns = 8;        // of a ramp
} // namespace

void StrokeWriter::cutTo(const glm::dvec3& aim, const glm::dvec3& tip) {
    points_.push_back({aim, speeds_.cutting});
    heights_->cut(tip_, tip);
    tip_ = tip;
}

void StrokeWriter::creepTo(const glm::dvec3& tip) {
    constexpr double slowest = 1.0; // mm/s
    const double seconds = 1.5 * MotionLimits{}.cornerSeconds;
    points_.push_back({tip, std::clamp(glm::distance(points_.back().tip, tip) / seconds, slowest, speeds_.cutting)});
    heights_->cut(tip_, tip);
    tip_ = tip;
}

void StrokeWriter::enterAt(const glm::dvec3& aim, const glm::dvec3& tip) {
    finish();
    const glm::dvec3 above(aim.x, aim.y, travelLevel());
    points_.push_back({above, speeds_.travelling});
    const double slow = std::min(above.z, heights_->freeTip(tip.x, tip.y) + approach);
    if (slow > tip.z) points_.push_back({{aim.x, aim.y, slow}, speeds_.travelling});
    points_.push_back({aim, slow > tip.z ? speeds_.plunging : speeds_.travelling});
    heights_->cut(tip);
    tip_ = tip;
}

void StrokeWriter::rampTo(const glm::dvec3& tip) {
    points_.push_back({tip, speeds_.plunging});
    heights_->cut(tip_, tip);
    tip_ = tip;
}

double StrokeWriter::depthAt(const glm::dvec3& tip) const noexcept {
    // Beside a wall that it has cut, the raster leaves stock at the edge of the tool.
    const double stock = heights_->freeTip(tip.x, tip.y, heights_->raster());
    return std::max(0.0, std::min(travelLevel(), stock) - tip.z);
}

void StrokeWriter::rampInto(const glm::dvec3& entry, const glm::dvec3& other) {
    const double depth = depthAt(entry), length = glm::distance(entry, other);
    if (depth <= plungeDepth || length <= 0.0) return enterAt(entry, entry);
    const glm::dvec3 surface = entry + glm::dvec3(0.0, 0.0, depth);
    const bool above = !empty() && glm::distance(glm::dvec2(tip_), glm::dvec2(entry)) <= heightTolerance &&
                       tip_.z >= surface.z - heightTolerance;
    if (above)
        rampTo(surface);
    else
        enterAt(surface, surface);
    // Whole turns, so that the ramp ends where the stroke begins. A short interval needs many turns, or the ramp gets
    // steep.
    const double leg = std::min(length, longestLeg);
    const glm::dvec3 far = glm::mix(entry, other, leg / length);
    const int turns = std::clamp(static_cast<int>(std::ceil(0.5 * depth / (rampSlope * leg))), 1, mostTurns);
    for (int i = 1; i <= 2 * turns; ++i) {
        glm::dvec3 tip = i % 2 == 1 ? far : entry;
        tip.z = entry.z + depth * (1.0 - static_cast<double>(i) / (2 * turns));
        rampTo(tip);
    }
}

void StrokeWriter::finish() {
    if (points_.empty() || points_.back().tip.z >= travelLevel()) return;
    points_.push_back({{points_.back().tip.x, points_.back().tip.y, travelLevel()}, speeds_.travelling});
}

Result<void> checkAbove(NamedNumbers numbers) {
    for (const auto& [name, value] : numbers)
        if (!(std::isfinite(value) && value > 0.0))
            return Error{ErrorCode::argumentInvalid, name, formatShortest(value), "a finite number above 0"};
    return {};
}

Result<void> checkNotBelow(NamedNumbers numbers) {
    for (const auto& [name, value] : numbers)
        if (!(std::isfinite(value) && value >= 0.0))
            return Error{ErrorCode::argumentInvalid, name, formatShortest(value), "a finite number, not below 0"};
    return {};
}

Result<void> checkSpeeds(const HandSpeeds& speeds) {
    return checkAbove({{"cutting speed", speeds.cutting},
                       {"plunging speed", speeds.plunging},
                       {"travelling speed", speeds.travelling}});
}

EvenPlaces evenPlaces(double low, double high, double spacing) {
    return {low, high - low, std::max(1, static_cast<int>(std::ceil((high - low) / spacing - 1e-6)))};
}

EvenPlaces passesOver(const FinishingRequest& request, const Cutter& cutter, int axis, double spacing) {
    const double reach = cutter.radius() + request.floorMargin;
    return evenPlaces(request.part.low[axis] - reach, request.part.high[axis] + reach, spacing);
}

double passSampling(const Cutter& cutter) {
    return std::clamp(0.125 * cutter.radius(), 0.02, 0.4);
}

} // namespace burin
