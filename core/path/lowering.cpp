// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/lowering.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double shortestStep = 0.02;   // mm on the way down
constexpr double touchPrecision = 1e-5; // mm of the position where the tool touches

} // namespace

/// The tool can go down by as much as it is farther than it has to be. Beside a wall that leads to ever shorter steps,
/// hence a shortest one, and the place between two of them by halving.
std::optional<glm::dvec3> Lowering::alongAxis(glm::dvec3 tip) const {
    const auto spareAt = [&](double z) {
        return guard_.clearance({tip.x, tip.y, z}, distance_ + 1e3).clearance - distance_;
    };
    double high = std::max(guard_.top() + distance_ + shortestStep, floor_), spare = spareAt(high);
    double low = high;
    while (spare > 0.0) {
        if (high <= floor_) return {};
        low = std::max(floor_, high - std::max(spare, shortestStep));
        spare = spareAt(low);
        if (spare > 0.0) high = low;
    }
    while (high - low > touchPrecision) {
        const double middle = 0.5 * (low + high);
        (spareAt(middle) > 0.0 ? high : low) = middle;
    }
    return glm::dvec3{tip.x, tip.y, high};
}

std::optional<glm::dvec3> Lowering::alongNormal(glm::dvec3 tip) const {
    constexpr int attempts = 40;
    for (int i = 0; i < attempts; ++i) {
        const ToolClearance now = guard_.clearance(tip, 1e3);
        const double missing = distance_ - now.clearance;
        if (std::abs(missing) <= touchPrecision) return tip;
        tip += missing * now.away;
    }
    return {};
}

std::vector<PathStroke> lowered(const PathStroke& stroke, const Lowering& lowering, double sampling,
                                const Progress& progress) {
    std::vector<StrokePoint> places;
    for (const StrokePoint& point : stroke.points) {
        if (!places.empty()) {
            const StrokePoint before = places.back();
            const double length = glm::distance(before.pose.tip, point.pose.tip);
            const auto steps = static_cast<int>(std::max(1.0, std::ceil(length / sampling)));
            for (int k = 1; k < steps; ++k) {
                StrokePoint between = point;
                between.sample = before.sample;
                between.pose.tip = glm::mix(before.pose.tip, point.pose.tip, static_cast<double>(k) / steps);
                places.push_back(between);
            }
        }
        places.push_back(point);
    }
    std::vector<std::optional<glm::dvec3>> tips(places.size());
    parallelFor(std::size_t{0}, places.size(), [&](std::size_t i) {
        if (!progress.cancelled()) tips[i] = lowering.bring(places[i].pose.tip);
    });
    std::vector<PathStroke> strokes;
    bool begins = true;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (tips[i] && begins)
            strokes.push_back({stroke.source, stroke.allowance, stroke.required, stroke.tickPeriod, {}});
        begins = !tips[i];
        if (begins) continue;
        places[i].pose.tip = *tips[i];
        places[i].removes = places[i].onBoundary = true; // it lies on the part: no air
        strokes.back().points.push_back(places[i]);
    }
    return strokes;
}

} // namespace burin
