// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/shape_corners.h"

#include "core/geometry/angle.h"
#include "core/path/polyline.h"

#include <algorithm>
#include <cmath>

namespace burin {

ShapeCorners::ShapeCorners(std::span<const StrokePoint> points, std::span<const double> course,
                           const CornerRules& rules, const Progress& progress)
    : course_(course), rules_(rules) {
    const auto anywhere = [](const glm::dvec3&, const glm::dvec3&) { return true; };
    const std::vector<std::size_t> kept = simplifyInGroups(points, rules.detail, anywhere, progress);
    for (std::size_t k = 1; k + 1 < kept.size(); ++k) {
        const glm::dvec3 into = points[kept[k]].pose.tip - points[kept[k - 1]].pose.tip;
        const glm::dvec3 out = points[kept[k + 1]].pose.tip - points[kept[k]].pose.tip;
        const double leg = std::min(glm::length(into), glm::length(out));
        if (leg > 0.0) corners_.push_back({kept[k], {angleBetween(into, out), leg}});
    }
}

bool ShapeCorners::isFree(const Place& corner, std::span<const std::size_t> known) const {
    const double here = course_[corner.point];
    if (here < rules_.distance || course_.back() - here < rules_.distance) return false;
    return std::ranges::none_of(known,
                                [&](std::size_t other) { return std::abs(course_[other] - here) < rules_.distance; });
}

std::vector<std::size_t> ShapeCorners::sharperThan(const Corner& least) const {
    std::vector<std::size_t> sharp;
    for (const Place& corner : corners_)
        if (corner.is.turn >= least.turn && corner.is.leg >= least.leg &&
            isFree(corner, std::span(sharp).last(std::min<std::size_t>(sharp.size(), 1))))
            sharp.push_back(corner.point);
    return sharp;
}

std::vector<std::size_t> ShapeCorners::withCornersAt(const std::vector<bool>& marked, const Corner& least,
                                                     std::span<const std::size_t> known) const {
    std::vector<std::size_t> all(known.begin(), known.end());
    for (std::size_t i = 0; i < marked.size(); ++i) {
        if (!marked[i]) continue;
        std::size_t last = i;
        while (last + 1 < marked.size() && marked[last + 1]) ++last;
        Place sharpest{0, {least.turn, 0.0}};
        for (auto corner = std::ranges::lower_bound(corners_, course_[i] - rules_.reach, {},
                                                    [&](const Place& one) { return course_[one.point]; });
             corner != corners_.end() && course_[corner->point] <= course_[last] + rules_.reach; ++corner)
            if (corner->is.turn >= sharpest.is.turn && corner->is.leg >= least.leg && isFree(*corner, all))
                sharpest = *corner;
        if (sharpest.point > 0) all.insert(std::ranges::upper_bound(all, sharpest.point), sharpest.point);
        i = last;
    }
    return all;
}

} // namespace burin
