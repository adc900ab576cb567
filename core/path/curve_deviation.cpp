// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/curve_deviation.h"

#include "core/base/parallel.h"
#include "core/path/polyline.h"

#include <algorithm>

namespace burin {
StrokeCurve::StrokeCurve(std::span<const glm::dvec3> tips, double reach) : reach_(reach) {
    for (const glm::dvec3& tip : tips) {
        if (moving_.empty() || tip != moving_.back()) {
            lengths_.push_back(moving_.empty() ? 0.0 : lengths_.back() + glm::distance(moving_.back(), tip));
            moving_.push_back(tip);
        }
        at_.push_back(moving_.size() - 1);
    }
}

double StrokeCurve::distance(const glm::dvec3& tip, std::size_t point, double enough) const noexcept {
    const std::size_t index = at_[point];
    double nearest = glm::distance(tip, moving_[index]);
    for (std::size_t k = 0; nearest > enough; ++k) {
        const bool below = index > k && lengths_[index] - lengths_[index - k] <= reach_;
        const bool above = index + k + 1 < moving_.size() && lengths_[index + k] - lengths_[index] <= reach_;
        if (!below && !above) break;
        if (below) nearest = std::min(nearest, distanceToSegment(tip, moving_[index - k - 1], moving_[index - k]));
        if (above) nearest = std::min(nearest, distanceToSegment(tip, moving_[index + k], moving_[index + k + 1]));
    }
    return nearest;
}

Deviation curveDeviation(std::span<const glm::dvec3> before, std::span<const glm::dvec3> after, double reach) {
    const StrokeCurve from(before, reach), to(after, reach);
    // The first of the farthest points counts, however many threads look for it.
    constexpr std::size_t together = 4096; // points
    std::vector<Deviation> farthest((before.size() + together - 1) / together);
    parallelFor(std::size_t{0}, farthest.size(), [&](std::size_t part) {
        for (std::size_t i = part * together; i < std::min((part + 1) * together, before.size()); ++i) {
            farthest[part].include(to.distance(before[i], i, farthest[part].distance), after[i]);
            farthest[part].include(from.distance(after[i], i, farthest[part].distance), after[i]);
        }
    });
    Deviation all;
    for (const Deviation& part : farthest) all.include(part);
    return all;
}

} // namespace burin
