// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/path/apply.h"
#include "core/path/divided_move.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

const double flank = std::tan(30.0 * pi / 180.0);
constexpr double finest = 0.2; // mm between points over a tab

/// The position of a tab, and the height of the tip over it.
class Tab {
public:
    /// @param half mm in plan within which the tip is fully lifted
    Tab(const glm::dvec3& place, double half, double height)
        : place_(place), half_(half), height_(height), reach_(half + height / flank) {}

    /// The tab stands on the lowest point of any stroke over it.
    void standOn(const glm::dvec3& tip) {
        if (distanceTo(tip) <= half_) floor_ = std::min(floor_.value_or(tip.z), tip.z);
    }
    double lifted(const glm::dvec3& tip) const {
        const double beyond = std::max(0.0, distanceTo(tip) - half_);
        return floor_ ? std::max(tip.z, *floor_ + height_ - flank * beyond) : tip.z;
    }
    /// Whether a straight move comes so near that part of it may have to be lifted.
    bool meets(const glm::dvec3& from, const glm::dvec3& to) const {
        const glm::dvec2 way(to - from), start(place_ - from);
        const double square = glm::dot(way, way);
        const double share = square > 0.0 ? std::clamp(glm::dot(start, way) / square, 0.0, 1.0) : 0.0;
        return floor_ && glm::distance(start, share * way) < reach_;
    }

private:
    double distanceTo(const glm::dvec3& tip) const { return glm::distance(glm::dvec2(tip), glm::dvec2(place_)); }

    glm::dvec3 place_;
    double half_, height_, reach_; ///< mm
    std::optional<double> floor_;  ///< mm
};

/// Inserts points closely enough where a tab has to be crossed; the recorded points stay.
std::vector<StrokePoint> divided(const std::vector<StrokePoint>& points, const std::vector<Tab>& tabs) {
    std::vector<StrokePoint> result;
    for (const StrokePoint& point : points) {
        const bool meets = !result.empty() && std::ranges::any_of(tabs, [&](const Tab& tab) {
            return tab.meets(result.back().pose.tip, point.pose.tip);
        });
        if (meets)
            addDivided(result, point, finest);
        else
            result.push_back(point);
    }
    return result;
}

} // namespace

Result<Deviation> apply(const KeepTabs& edit, PathUnderEdit& state, const PathContext& context, Progress&) {
    std::vector<Tab> tabs;
    // The cutter removes half of its width on both sides.
    const double half = 0.5 * (edit.width + context.tool.cutter.diameter);
    for (const glm::dvec3& place : edit.places) tabs.emplace_back(place, half, edit.height);
    // The floor of a tab is found from whole moves: a long one may pass the tab without a point near it.
    for (Tab& tab : tabs)
        for (const PathStroke& stroke : state.strokes)
            for (std::size_t i = 0; i < stroke.points.size(); ++i) {
                const glm::dvec3& to = stroke.points[i].pose.tip;
                const glm::dvec3& from = stroke.points[i > 0 ? i - 1 : 0].pose.tip;
                const int parts = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / finest)));
                for (int part = 1; part <= parts; ++part)
                    tab.standOn(glm::mix(from, to, static_cast<double>(part) / parts));
            }
    for (PathStroke& stroke : state.strokes) {
        stroke.points = divided(stroke.points, tabs);
        for (StrokePoint& point : stroke.points)
            for (const Tab& tab : tabs) {
                const double height = tab.lifted(point.pose.tip);
                if (height <= point.pose.tip.z) continue;
                point.pose.tip.z = height;
                point.onBoundary = false;
            }
    }
    return Deviation{}; // changed on purpose
}

} // namespace burin
