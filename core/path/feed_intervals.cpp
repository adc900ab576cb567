// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/feed_intervals.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace burin {
namespace {

/// Divides moves, one interval after the other.
class Divider {
public:
    Divider(const std::vector<PathPoint>& points, double leastChange) : points_(points), leastChange_(leastChange) {}

    /// @param speed 1/min; empty: the move keeps its own
    void add(const MetInterval& met, double feed, std::optional<double> speed) {
        const bool isArc = points_[met.move].arc.has_value();
        const bool alike = std::max(high_, feed) <= (1.0 + leastChange_) * std::min(low_, feed) && speed == speed_;
        const bool goesOn = met.move == move_ && (isArc || alike);
        if (!goesOn) finish();
        if (met.move != move_) copyUpTo(met.move);
        if (!goesOn) {
            low_ = high_ = feed;
            speed_ = speed;
        }
        if (speed) speed_ = std::min(*speed, speed_.value_or(*speed));
        low_ = std::min(low_, feed);
        high_ = std::max(high_, feed);
        end_ = met.to;
        ends_ = met.end >= 1.0;
        open_ = true;
    }
    std::vector<PathPoint> take() {
        finish();
        copyUpTo(points_.size());
        return std::move(divided_);
    }

private:
    /// Finishes the open block.
    void finish() {
        if (!open_) return;
        PathPoint point = points_[move_];
        if (!ends_) point.pose.tip = end_;
        point.feed = low_;
        if (speed_) point.spindleSpeed = *speed_;
        divided_.push_back(point);
        open_ = false;
        if (ends_) ++next_;
    }
    /// Copies moves that keep their feed.
    void copyUpTo(std::size_t move) {
        while (next_ < move) divided_.push_back(points_[next_++]);
        move_ = move;
    }

    const std::vector<PathPoint>& points_;
    double leastChange_;
    std::vector<PathPoint> divided_;
    std::size_t next_ = 0, move_ = std::numeric_limits<std::size_t>::max();
    double low_ = 0.0, high_ = 0.0;
    std::optional<double> speed_; ///< 1/min
    glm::dvec3 end_{0.0};
    bool open_ = false, ends_ = false;
};

} // namespace

std::vector<PathPoint> withFeeds(const std::vector<PathPoint>& points, const std::vector<MetInterval>& record,
                                 const std::vector<double>& feeds, double leastChange,
                                 const std::vector<double>& speeds) {
    Divider divider(points, leastChange);
    for (std::size_t i = 0; i < feeds.size(); ++i)
        divider.add(record[i], feeds[i], speeds.empty() ? std::nullopt : std::optional(speeds[i]));
    return divider.take();
}

std::vector<double> leastOfNeighbours(const std::vector<MetInterval>& record, const std::vector<PathPoint>& points,
                                      const std::vector<double>& feeds) {
    const auto isCut = [&](std::size_t i) { return points[record[i].move].kind == MoveKind::cut; };
    const auto shareOf = [&](std::size_t i) { return feeds[i] / points[record[i].move].feed; };
    std::vector<double> least = feeds;
    const auto follow = [&](std::size_t i, std::size_t other) {
        least[i] = std::min(least[i], points[record[i].move].feed * shareOf(other));
    };
    for (std::size_t i = 0; i + 1 < feeds.size(); ++i) {
        if (record[i + 1].from != record[i].to || !isCut(i) || !isCut(i + 1)) continue; // there is a rapid between them
        follow(i, i + 1);
        follow(i + 1, i);
    }
    return least;
}

} // namespace burin
