// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/plan_offset.h"

#include "core/base/units.h"
#include "core/path/polyline.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Tolerance for simplifying the polyline, and for the chords of rounded corners, mm.
constexpr double planChordTolerance = 0.001;
/// Spacing of the checked points of the raw curve, mm: a smaller loop may stay.
constexpr double sampling = 0.05;
/// A point that is nearer to the polyline than its distance by more than this belongs to a loop, mm.
constexpr double slack = 1e-6;
/// The ends of a removed loop meet within this, else the curve is interrupted there, mm.
constexpr double meeting = 0.01;

double distanceInPlan(const glm::dvec3& place, std::span<const StrokePoint> line) {
    double nearest = 1e300;
    const glm::dvec3 flat(1.0, 1.0, 0.0);
    for (std::size_t i = 1; i < line.size(); ++i)
        nearest =
            std::min(nearest, distanceToSegment(flat * place, flat * line[i - 1].pose.tip, flat * line[i].pose.tip));
    return nearest;
}

/// The shifted moves, outside corners rounded, loops not yet removed.
class RawOffset {
public:
    RawOffset(std::span<const StrokePoint> points, double distance) : distance_(distance) {
        for (std::size_t i = 1; i < points.size(); ++i) {
            const glm::dvec3 way = points[i].pose.tip - points[i - 1].pose.tip;
            const double length = std::hypot(way.x, way.y);
            if (!(length > 0.0)) continue;
            const glm::dvec3 side(-way.y / length, way.x / length, 0.0);
            if (!places.empty()) round(points[i - 1], side);
            shift(points[i - 1], side);
            const auto steps = static_cast<int>(std::ceil(length / sampling));
            for (int k = 1; k < steps; ++k) {
                StrokePoint between = points[i - 1];
                between.pose.tip = glm::mix(points[i - 1].pose.tip, points[i].pose.tip, static_cast<double>(k) / steps);
                shift(between, side);
            }
            shift(points[i], side);
            side_ = side;
        }
    }

    std::vector<StrokePoint> places;

private:
    void shift(StrokePoint point, const glm::dvec3& side) {
        point.pose.tip += distance_ * side;
        point.removes = true; // unknown material: not an air cut
        point.onBoundary = false;
        places.push_back(point);
    }
    void round(const StrokePoint& corner, const glm::dvec3& side) {
        const double turn = std::atan2(side_.x * side.y - side_.y * side.x, glm::dot(side_, side));
        if (turn * distance_ >= 0.0) return; // the inside: moves cross
        const double finest = 2.0 * std::acos(std::max(0.5, 1.0 - planChordTolerance / std::abs(distance_)));
        const int steps = static_cast<int>(std::ceil(std::abs(turn) / finest));
        const double start = std::atan2(side_.y, side_.x);
        for (int k = 1; k < steps; ++k) {
            const double angle = start + turn * k / steps;
            shift(corner, {std::cos(angle), std::sin(angle), 0.0});
        }
    }

    double distance_;
    glm::dvec3 side_{0.0};
};

/// The last point before a loop, or the first behind it.
StrokePoint border(StrokePoint good, const StrokePoint& bad, std::span<const StrokePoint> line, double least) {
    double in = 0.0, out = 1.0;
    const glm::dvec3 from = good.pose.tip;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (in + out);
        (distanceInPlan(glm::mix(from, bad.pose.tip, middle), line) >= least ? in : out) = middle;
    }
    good.pose.tip = glm::mix(from, bad.pose.tip, in);
    return good;
}

} // namespace

std::vector<std::vector<StrokePoint>> offsetInPlan(std::span<const StrokePoint> points, double distance) {
    std::vector<StrokePoint> line(points.begin(), points.end());
    keepOnly(line, simplify(line, planChordTolerance, [](const glm::dvec3&, const glm::dvec3&) { return true; }));
    if (distance == 0.0 || line.size() < 2) return {line};
    const std::vector<StrokePoint> raw = RawOffset(line, distance).places;
    const double least = std::abs(distance) - planChordTolerance - slack;
    std::vector<std::vector<StrokePoint>> pieces;
    bool good = false;
    for (std::size_t i = 0; i < raw.size(); ++i) {
        const bool here = distanceInPlan(raw[i].pose.tip, line) >= least;
        if (here && !good) {
            const StrokePoint start = i > 0 ? border(raw[i], raw[i - 1], line, least) : raw[i];
            if (pieces.empty() || glm::distance(pieces.back().back().pose.tip, start.pose.tip) > meeting)
                pieces.emplace_back();
            if (i > 0) pieces.back().push_back(start);
        }
        if (!here && good) pieces.back().push_back(border(raw[i - 1], raw[i], line, least));
        if (here) pieces.back().push_back(raw[i]);
        good = here;
    }
    return pieces;
}

} // namespace burin
