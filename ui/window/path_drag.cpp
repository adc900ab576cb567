// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/path_drag.h"

#include "core/path/hand_interval.h"

#include <algorithm>

namespace burin {

namespace {

constexpr double draggedSteps = 16.0; // number of steps of an arc while it is dragged

class DraggedShape {
public:
    DraggedShape(const std::vector<PathPoint>& points, const PathPlace& place, const glm::dvec3& by, double reach,
                 const DragShare& shareAt)
        : points_(points), place_(place), start_(placeOf(points, place)), by_(by), reach_(reach), shareAt_(shareAt) {}

    std::vector<glm::dvec3> places() const {
        std::vector<glm::dvec3> moved{start_ + by_};
        follow(moved, -1);
        std::ranges::reverse(moved);
        follow(moved, 1);
        return moved;
    }

private:
    void follow(std::vector<glm::dvec3>& moved, std::ptrdiff_t step) const {
        const std::int64_t take = points_[place_.nearestPoint()].source;
        const double end = step < 0 ? 0.0 : 1.0;
        PathPlace at = place_;
        glm::dvec3 from = start_;
        double distance = 0.0;
        const auto pieces = static_cast<std::ptrdiff_t>(points_.size()) - 1;
        for (auto piece = static_cast<std::ptrdiff_t>(place_.piece); piece >= 0 && piece < pieces; piece += step) {
            at.piece = static_cast<std::size_t>(piece);
            const PathPoint& point = points_[at.piece + (step < 0 ? 0 : 1)];
            if (distance >= reach_ || !hasMoment(point) || point.source != take) return;
            const double steps = points_[at.piece + 1].arc ? draggedSteps : 1.0, begin = at.share;
            for (double i = 1.0; i <= steps; i += 1.0) {
                at.share = glm::mix(begin, end, i / steps);
                const glm::dvec3 place = placeOf(points_, at);
                distance += glm::distance(place, from);
                from = place;
                moved.push_back(place + shareAt_(distance) * by_);
            }
            at.share = 1.0 - end;
        }
    }

    const std::vector<PathPoint>& points_;
    PathPlace place_;
    glm::dvec3 start_; ///< mm, initial position of the point
    glm::dvec3 by_;
    double reach_; ///< mm
    const DragShare& shareAt_;
};

} // namespace

Arc arcOf(const glm::dvec3& from, const PathPoint& to) {
    return {from, to.pose.tip, to.arc->centre, to.arc->axis, to.arc->clockwise};
}

glm::dvec3 placeOf(const std::vector<PathPoint>& points, const PathPlace& place) {
    const PathPoint &from = points[place.piece], &to = points[place.piece + 1];
    if (!to.arc) return glm::mix(from.pose.tip, to.pose.tip, place.share);
    const Arc arc = arcOf(from.pose.tip, to);
    return placeOn(arc, turnOf(arc), place.share);
}

std::vector<glm::dvec3> draggedShape(const std::vector<PathPoint>& points, const PathPlace& place, const glm::dvec3& by,
                                     double reach, const DragShare& shareAt) {
    return DraggedShape(points, place, by, reach, shareAt).places();
}

} // namespace burin
