// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/apply.h"

#include <span>
#include <vector>

namespace burin {

struct CornerRules {
    double detail = 0.0;   ///< mm: bends within this tolerance do not count
    double distance = 0.0; ///< mm of the course between two corners, and between a corner and an end, at least
    double reach = 0.0;    ///< mm of the course around a marked point that are searched for its corner
};

/// The corners of a stroke, simplified to `CornerRules::detail`.
class ShapeCorners {
public:
    struct Corner {
        double turn = 0.0; ///< rad
        double leg = 0.0;  ///< mm, of the shorter of the two straight moves that meet
    };

    /// Keeps a reference to the course. @param course mm, of each point, non-decreasing
    ShapeCorners(std::span<const StrokePoint> points, std::span<const double> course, const CornerRules& rules,
                 const Progress& progress);

    /// All corners with at least this turn and legs at least this long. @return points, ascending
    std::vector<std::size_t> sharperThan(const Corner& least) const;
    /// The corners that explain marked points: for each marked interval, the sharpest turn of the stroke near by.
    /// @param marked one per point
    /// @param known existing corners, ascending @return those and the new ones, ascending
    std::vector<std::size_t> withCornersAt(const std::vector<bool>& marked, const Corner& least,
                                           std::span<const std::size_t> known) const;

private:
    struct Place {
        std::size_t point = 0;
        Corner is;
    };
    bool isFree(const Place& corner, std::span<const std::size_t> known) const;

    std::span<const double> course_; // mm
    CornerRules rules_;
    std::vector<Place> corners_; // ascending
};

} // namespace burin
