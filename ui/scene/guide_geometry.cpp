// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/guide_geometry.h"

#include "core/base/units.h"
#include "core/geometry/frame_along.h"
#include "ui/scene/path_thinner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr double cornerStep = 15.0 * pi / 180.0;
constexpr double tooNear = 0.999; // fraction of the distance: points nearer to the pass don't belong to the guide
constexpr double most = 1e9;      // levels

/// Sorts the corners of a convex polygon by their angle about its centre.
void putInOrder(Polygon& corners, const glm::dvec3& normal) {
    glm::dvec3 middle(0.0);
    for (const glm::dvec3& corner : corners) middle += corner / static_cast<double>(corners.size());
    const glm::dvec3 across = anyAcross(normal), up = glm::cross(normal, across);
    std::ranges::sort(corners, {}, [&](const glm::dvec3& corner) {
        return std::atan2(glm::dot(corner - middle, up), glm::dot(corner - middle, across));
    });
}

/// @param onIt the side to which corners on the plane itself are assigned
Polygon crossings(const Box& box, const std::array<double, 8>& heights, bool onIt) {
    const auto above = [&](unsigned corner) { return heights[corner] > 0.0 || (onIt && heights[corner] == 0.0); };
    Polygon corners;
    for (unsigned from = 0; from < 8; ++from)
        for (const unsigned bit : {1U, 2U, 4U}) {
            const unsigned to = from | bit;
            if (to == from || above(from) == above(to)) continue;
            const double share = heights[from] / (heights[from] - heights[to]);
            corners.push_back(glm::mix(box.corner(from), box.corner(to), share));
        }
    return corners;
}

/// Thins a pass.
std::vector<glm::dvec3> thinned(std::span<const glm::dvec3> pass) {
    std::vector<glm::dvec3> corners{pass.front()};
    PathThinner thinner(static_cast<float>(passTolerance));
    thinner.begin(glm::vec3(pass.front()));
    for (const glm::dvec3& place : pass.subspan(1)) {
        if (place == corners.back()) continue;
        if (thinner.add(glm::vec3(place)) || corners.size() == 1)
            corners.push_back(place);
        else
            corners.back() = place;
    }
    if (corners.size() <= passCorners) return corners;
    std::vector<glm::dvec3> even;
    for (std::size_t i = 0; i < passCorners; ++i) even.push_back(corners[i * (corners.size() - 1) / (passCorners - 1)]);
    return even;
}

/// A polyline as seen along a direction, extended straight beyond its ends.
class SeenPass {
public:
    SeenPass(std::vector<glm::dvec3> corners, const glm::dvec3& direction, double beyond)
        : corners_(std::move(corners)), direction_(direction) {
        std::erase_if(corners_,
                      [&, before = static_cast<const glm::dvec3*>(nullptr)](const glm::dvec3& corner) mutable {
                          const bool same = before != nullptr && glm::length(across(corner - *before)) < 1e-9;
                          if (!same) before = &corner;
                          return same;
                      });
        if (corners_.size() < 2) return;
        corners_.front() -= along(0) * beyond;
        corners_.back() += along(corners_.size() - 2) * beyond;
    }

    bool empty() const { return corners_.size() < 2; }
    Polygon side(double distance) const;
    bool touches(const glm::dvec3& place, double distance) const;

private:
    glm::dvec3 across(const glm::dvec3& way) const { return way - direction_ * glm::dot(direction_, way); }
    glm::dvec3 along(std::size_t segment) const {
        return glm::normalize(across(corners_[segment + 1] - corners_[segment]));
    }

    std::vector<glm::dvec3> corners_;
    glm::dvec3 direction_;
};

/// The offset curve next to every segment, rounded around the corners that bend away. @param distance < 0: on the right
Polygon SeenPass::side(double distance) const {
    Polygon places;
    for (std::size_t i = 0; i + 1 < corners_.size(); ++i) {
        const glm::dvec3 out = glm::cross(direction_, along(i));
        if (i > 0) {
            const glm::dvec3 before = glm::cross(direction_, along(i - 1));
            const double turn = std::atan2(glm::dot(direction_, glm::cross(before, out)), glm::dot(before, out));
            const int steps = static_cast<int>(std::abs(turn) / cornerStep);
            for (int step = 1; step <= steps; ++step) {
                const double angle = turn * step / (steps + 1);
                const glm::dvec3 between = before * std::cos(angle) + glm::cross(direction_, before) * std::sin(angle);
                places.push_back(corners_[i] + between * distance);
            }
        }
        places.push_back(corners_[i] + out * distance);
        places.push_back(corners_[i + 1] + out * distance);
    }
    return places;
}

bool SeenPass::touches(const glm::dvec3& place, double distance) const {
    for (std::size_t i = 0; i + 1 < corners_.size(); ++i) {
        const glm::dvec3 way = across(corners_[i + 1] - corners_[i]), to = across(place - corners_[i]);
        const double share = std::clamp(glm::dot(to, way) / glm::dot(way, way), 0.0, 1.0);
        if (glm::length(to - way * share) < distance) return true;
    }
    return false;
}

} // namespace

Polygon planeInBox(const Box& box, const glm::dvec3& point, const glm::dvec3& normal) {
    std::array<double, 8> heights{};
    for (unsigned i = 0; i < 8; ++i) heights[i] = glm::dot(normal, box.corner(i) - point);
    Polygon corners = crossings(box, heights, true);
    if (corners.empty()) corners = crossings(box, heights, false);
    if (corners.size() < 3) return {};
    putInOrder(corners, normal);
    return corners;
}

std::optional<std::pair<int, int>> levelsInBox(const Box& box, const glm::dvec3& point, const glm::dvec3& normal,
                                               double distance) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (unsigned i = 0; i < 8; ++i) {
        const double level = glm::dot(normal, box.corner(i) - point) / distance;
        low = std::min(low, level);
        high = std::max(high, level);
    }
    const double first = std::ceil(std::clamp(low, -most, most)), last = std::floor(std::clamp(high, -most, most));
    if (!(first <= last)) return std::nullopt;
    return std::pair(static_cast<int>(first), static_cast<int>(last));
}

std::optional<std::pair<glm::dvec3, glm::dvec3>> lineInBox(const Box& box, const glm::dvec3& point,
                                                           const glm::dvec3& direction) {
    double from = -std::numeric_limits<double>::infinity(), to = -from;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0.0) {
            if (point[axis] < box.low[axis] || point[axis] > box.high[axis]) return std::nullopt;
            continue;
        }
        const double one = (box.low[axis] - point[axis]) / direction[axis];
        const double other = (box.high[axis] - point[axis]) / direction[axis];
        from = std::max(from, std::min(one, other));
        to = std::min(to, std::max(one, other));
    }
    if (!(from < to)) return std::nullopt;
    return std::pair(point + direction * from, point + direction * to);
}

std::vector<Polygon> besidePass(std::span<const glm::dvec3> pass, const glm::dvec3& direction, double distance) {
    if (pass.size() < 2) return {};
    const SeenPass seen(thinned(pass), direction, 2.0 * distance);
    if (seen.empty()) return {};
    std::vector<Polygon> curves;
    for (const double side : {distance, -distance}) {
        Polygon piece;
        const auto finish = [&] {
            if (piece.size() > 1) curves.push_back(piece);
            piece.clear();
        };
        for (const glm::dvec3& place : seen.side(side)) {
            if (seen.touches(place, tooNear * distance))
                finish();
            else
                piece.push_back(place);
        }
        finish();
    }
    return curves;
}

} // namespace burin
