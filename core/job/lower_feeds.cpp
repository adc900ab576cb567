// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/lower_feeds.h"

#include <algorithm>

namespace burin {

namespace {

/// Share of the limit: a program's numbers are rounded, also upwards.
constexpr double written = 0.99;

/// A point of the concatenated paths.
struct PointOf {
    PathPoint* point = nullptr;
    double leastFeed = 0.0; ///< mm/min, of its path
};
std::vector<PointOf> pointsOf(std::vector<Path>& paths) {
    std::vector<PointOf> points;
    for (Path& path : paths)
        for (PathPoint& point : path.points) points.push_back({&point, path.leastFeed});
    return points;
}

} // namespace

Path wholeOf(const std::vector<Path>& paths) {
    Path whole;
    for (const Path& path : paths) whole.points.insert(whole.points.end(), path.points.begin(), path.points.end());
    return whole;
}

std::size_t lowerFeeds(std::vector<Path>& paths, const ParsedProgram& program, const std::vector<FeedLimit>& limits,
                       const Kinematics& kinematics) {
    const auto mayLower = [](const Path& path) { return path.leastFeed > 0.0; };
    if (limits.empty() || std::ranges::none_of(paths, mayLower)) return 0;
    const std::vector<std::optional<std::size_t>> behind = pointsBehind(program, wholeOf(paths), kinematics);
    const std::vector<PointOf> points = pointsOf(paths);
    std::vector<bool> lowered(points.size(), false);
    for (const FeedLimit& limit : limits) {
        const std::optional<std::size_t> number = behind[limit.motion];
        if (!number || !(points[*number].leastFeed > 0.0)) continue;
        PathPoint& point = *points[*number].point;
        const double feed = std::max(points[*number].leastFeed, written * limit.feed);
        if (point.kind == MoveKind::rapid || !(feed < point.feed)) continue;
        point.feed = feed;
        lowered[*number] = true;
    }
    return static_cast<std::size_t>(std::ranges::count(lowered, true));
}

} // namespace burin
