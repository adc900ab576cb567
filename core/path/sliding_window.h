// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace burin {

/// The points of a course within a distance of one point after the other: both ends only move on.
class SlidingWindow {
public:
    /// @param course mm, of each point, non-decreasing @param half mm
    SlidingWindow(std::span<const double> course, double half) noexcept : course_(course), half_(half) {}

    /// Points are visited in ascending order; the first may be any.
    void moveTo(std::size_t point) noexcept {
        const double low = course_[point] - half_, high = course_[point] + half_;
        if (!begun_) {
            first_ = static_cast<std::size_t>(std::ranges::lower_bound(course_, low) - course_.begin());
            end_ = static_cast<std::size_t>(std::ranges::upper_bound(course_, high) - course_.begin());
            begun_ = true;
            return;
        }
        while (first_ < course_.size() && course_[first_] < low) ++first_;
        while (end_ < course_.size() && course_[end_] <= high) ++end_;
    }
    std::size_t first() const noexcept { return first_; }
    std::size_t end() const noexcept { return end_; }

private:
    std::span<const double> course_;
    double half_;
    std::size_t first_ = 0, end_ = 0;
    bool begun_ = false;
};

} // namespace burin
