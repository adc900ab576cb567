// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/stated_axes.h"

#include "core/geometry/upright.h"
#include "core/path/stroke.h"

#include <algorithm>

namespace burin {

glm::dvec3 StatedAxes::at(const Moment& moment) const {
    const auto source = stated_.find(moment.source);
    if (source == stated_.end()) return uprightAxis;
    const auto after = source->second.upper_bound(moment.tick);
    return after == source->second.begin() ? uprightAxis : std::prev(after)->second;
}

std::vector<std::int64_t> StatedAxes::between(std::int64_t source, std::int64_t from, std::int64_t to) const {
    std::vector<std::int64_t> ticks;
    const auto found = stated_.find(source);
    if (found == stated_.end()) return ticks;
    const auto [low, high] = std::minmax(from, to);
    for (auto at = found->second.upper_bound(low); at != found->second.end() && at->first < high; ++at)
        ticks.push_back(at->first);
    if (from > to) std::ranges::reverse(ticks);
    return ticks;
}

std::size_t StatedAxes::bytes() const noexcept {
    constexpr std::size_t node = 4 * sizeof(void*); // of a tree, for each entry
    std::size_t bytes = sizeof(StatedAxes);
    for (const auto& [source, axes] : stated_)
        bytes += node + sizeof(axes) + axes.size() * (node + sizeof(std::int64_t) + sizeof(glm::dvec3));
    return bytes;
}

Result<void> StatedAxes::take(SourceStrokes& source, const Tool& tool) {
    const auto tilted = [](const StrokePoint& point) { return !isUpright(point.pose.axis); };
    if (std::ranges::none_of(source.strokes,
                             [&](const PathStroke& s) { return std::ranges::any_of(s.points, tilted); }))
        return {};
    if (tool.cutter.type != CutterType::ball || tool.cutter.solid != nullptr)
        return Error{ErrorCode::notSupported, "tilted tool axis", "moves of a ball end mill, or upright ones",
                     nameOf(source.info.source)};
    std::map<std::int64_t, glm::dvec3>& axes = stated_[source.info.source.id];
    for (PathStroke& stroke : source.strokes)
        for (StrokePoint& point : stroke.points) {
            axes[point.sample] = point.pose.axis;
            point.pose.tip += tool.cutter.radius() * (point.pose.axis - uprightAxis);
            point.pose.axis = uprightAxis;
        }
    return {};
}

} // namespace burin
