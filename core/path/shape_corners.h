// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/apply.h"

#include <span>
#include <vector>

namespace burin {

struct CornerRules {
    double detail = 0.0;   ///< mm: bends that stay within it are none
    double distance = 0.0; ///< mm of the course between two corners, and between a corner and an end, at least
    double reach = 0.0;    ///< mm of the course around a marked point that its corner is looked for in
};

/// The corners of a stroke: where it turns, once the detail is left out of it.
class ShapeCorners {
public:
    struct Corner {
        double turn = 0.0; ///< rad
        double leg = 0.0;  ///< mm, the shorter one of the two straight moves that meet
    };

    /// Keeps a reference to the course. @param course mm, of each point, never falling
    ShapeCorners(std::span<const StrokePoint> points, std::span<const double> course, const CornerRules& rules,
                 const Progress& progress);

    /// All that turn by so much at least, between legs that are as long. @return points, ascending
    std::vector<std::size_t> sharperThan(const Corner& least) const;
    /// Those that explain marked points: for each stretch of these, where the stroke turns most near by.
    /// @param marked as many as points
    /// @param known corners that are there already, ascending @return those and the new ones, ascending
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
