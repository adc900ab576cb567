// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/shape_tube.h"

#include "core/base/parallel.h"

#include <algorithm>

namespace burin {
namespace {

/// How often the weight of points outside the tube is increased.
constexpr int tubeRounds = 16;
constexpr double tubeAim = 0.97;               // share of the tolerance
constexpr std::size_t comparedTogether = 4096; // points that justify another core

} // namespace

ShapeTube::ShapeTube(std::vector<glm::dvec3> tips, double tolerance, double reach)
    : tips_(std::move(tips)), curve_(tips_, reach), tolerance_(tolerance), reach_(reach) {}

/// The distance of each point from the other curve, mm; within the tolerance any value up to it.
std::vector<double> ShapeTube::offsets(std::span<const glm::dvec3> smoothed) const {
    const StrokeCurve other(smoothed, reach_);
    std::vector<double> offsets(tips_.size(), 0.0);
    parallelIntervals(std::size_t{0}, tips_.size(), comparedTogether, [&](std::size_t from, std::size_t end) {
        for (std::size_t i = from; i != end; ++i)
            if (glm::distance(tips_[i], smoothed[i]) > tolerance_)
                offsets[i] =
                    std::max(other.distance(tips_[i], i, tolerance_), curve_.distance(smoothed[i], i, tolerance_));
    });
    return offsets;
}

std::vector<bool> ShapeTube::outside(std::span<const glm::dvec3> smoothed) const {
    const std::vector<double> off = offsets(smoothed);
    std::vector<bool> marked(off.size());
    for (std::size_t i = 0; i < off.size(); ++i) marked[i] = off[i] > tolerance_;
    return marked;
}

std::vector<glm::dvec3> ShapeTube::drawIn(ShapeFit& fit, const Progress& progress) const {
    std::vector<glm::dvec3> smoothed(tips_.size());
    for (int round = 0; round <= tubeRounds && !progress.cancelled(); ++round) {
        fit.fit();
        for (std::size_t i = 0; i < smoothed.size(); ++i) smoothed[i] = fit.tip(i);
        const std::vector<double> off = offsets(smoothed);
        bool within = true;
        for (std::size_t i = 0; i < smoothed.size(); ++i) {
            if (off[i] <= tolerance_) continue;
            within = false;
            const double times = off[i] / (tubeAim * tolerance_);
            fit.weigh(i, times * times);
        }
        if (within) break;
    }
    return smoothed;
}

void ShapeTube::restoreOutside(std::vector<glm::dvec3>& smoothed, const Progress& progress) const {
    for (std::size_t around = 0; !progress.cancelled(); around = 2 * around + 1) {
        const std::vector<bool> off = outside(smoothed);
        bool within = true;
        for (std::size_t i = 0; i < off.size(); ++i) {
            if (!off[i]) continue;
            within = false;
            const std::size_t first = i - std::min(i, around), last = std::min(i + around, off.size() - 1);
            for (std::size_t k = first; k <= last; ++k) smoothed[k] = tips_[k];
        }
        if (within) return;
    }
}

} // namespace burin
