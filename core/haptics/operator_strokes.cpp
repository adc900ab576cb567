// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/operator_strokes.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {
constexpr double approach = 1.0; // mm above stock at which coming down gets slow
} // namespace

void StrokeWriter::cutTo(const glm::dvec3& aim, const glm::dvec3& tip) {
    points_.push_back({aim, speeds_.cutting});
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
