// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/lead.h"

#include "core/base/units.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {
namespace {

/// The direction in which a stroke starts, horizontal and of unit length; zero if it goes straight up or down.
glm::dvec3 directionAtStart(const PathStroke& stroke) {
    const StrokePoint &first = stroke.points[0], &second = stroke.points[1];
    glm::dvec3 way = second.pose.tip - first.pose.tip;
    if (second.arc && second.arc->axis == 2) {
        const glm::dvec3 out = first.pose.tip - second.arc->centre;
        way = second.arc->clockwise ? glm::dvec3(out.y, -out.x, 0.0) : glm::dvec3(-out.y, out.x, 0.0);
    }
    way.z = 0.0;
    const double length = glm::length(way);
    return length > 1e-9 ? way / length : glm::dvec3(0.0);
}

constexpr std::array shares{1.0, 0.5, 0.25}; // of a lead's size, in the order in which they are tried

/// A stroke's own direction, limited to the angle from the hand's by which a short first move may deviate by chance.
/// @param own horizontal, of unit length or zero
glm::dvec3 heldTo(const glm::dvec3& hand, const glm::dvec3& own) {
    constexpr double farthest = 60.0 * pi / 180.0;
    const double turn = std::atan2(hand.x * own.y - hand.y * own.x, glm::dot(hand, own)); // 0 if there is none
    if (own != glm::dvec3(0.0) && std::abs(turn) <= farthest) return own;
    const double by = std::clamp(turn, -farthest, farthest), cosine = std::cos(by), sine = std::sin(by);
    return {cosine * hand.x - sine * hand.y, sine * hand.x + cosine * hand.y, 0.0};
}

StrokePoint pointAt(const glm::dvec3& tip) {
    StrokePoint point;
    point.pose.tip = tip;
    point.removes = true; // it cuts any material that it meets
    return point;
}

} // namespace

LeadFinder::LeadFinder(const LeadShape& shape, const PartGuard& guard, const PathContext& context)
    : shape_(shape), guard_(guard) {
    for (const ObstacleSolid& obstacle : context.obstacles)
        if (obstacle.on) obstacles_.emplace_back(PartGuard(*obstacle.surface, context.tool), obstacle.margin);
}

/// The side on which a lead has room at the start of the recording; left if it has on both, or on none.
double LeadFinder::sideAt(const HandStart& start, double required) const {
    constexpr double slack = 0.1; // mm, by which a hand may be nearer to the part than the edited stroke
    for (const double share : shares)
        for (const double side : {1.0, -1.0})
            if (share >= shape_.smallestShare &&
                isClear(made(start.tip, start.direction, share * shape_.size, side), required - slack))
                return side;
    return 1.0;
}

std::vector<StrokePoint> LeadFinder::into(const PathStroke& stroke, const HandStart* recorded) const {
    if (stroke.points.size() < 2) return {};
    glm::dvec3 direction = directionAtStart(stroke);
    if (recorded != nullptr) direction = heldTo(recorded->direction, direction);
    if (direction == glm::dvec3(0.0)) return {};
    const double first = recorded != nullptr ? sideAt(*recorded, stroke.required) : 1.0;
    const auto tried = [&](double share, double side) {
        std::vector<StrokePoint> way = made(stroke.points.front().pose.tip, direction, share * shape_.size, side);
        if (share < shape_.smallestShare || !isClear(way, stroke.required)) way.clear();
        for (StrokePoint& point : way) point.sample = stroke.points.front().sample;
        return way;
    };
    // By the recording, a smaller size on the same side comes before the other side.
    if (recorded != nullptr) {
        for (const double side : {first, -first})
            for (const double share : shares)
                if (std::vector<StrokePoint> way = tried(share, side); !way.empty()) return way;
        return {};
    }
    for (const double share : shares)
        for (const double side : {1.0, -1.0})
            if (std::vector<StrokePoint> way = tried(share, side); !way.empty()) return way;
    return {};
}

/// @param side 1: the circle's centre lies on the left
std::vector<StrokePoint> LeadFinder::made(const glm::dvec3& end, const glm::dvec3& direction, double size,
                                          double side) const {
    const glm::dvec3 up(0.0, 0.0, 1.0), left(-direction.y, direction.x, 0.0);
    const glm::dvec3 centre = end + side * size * left;
    const PathArc turn{centre, 2, side < 0.0};
    std::vector<StrokePoint> way;
    if (shape_.form == LeadIn::Form::line || shape_.form == LeadIn::Form::ramp) {
        const double rise = shape_.form == LeadIn::Form::ramp ? shape_.height : 0.0;
        return {pointAt(end - size * direction + rise * up), pointAt(end)};
    }
    if (shape_.form == LeadIn::Form::arc) {
        way = {pointAt(centre - size * direction), pointAt(end)};
        way.back().arc = turn;
        return way;
    }
    // Half turns, as a control may take a full turn for no motion at all.
    const double halfTurn = pi * size * std::tan(shape_.angle);
    const auto halves = static_cast<int>(std::max(1.0, std::ceil(shape_.height / halfTurn)));
    for (int i = halves; i >= 0; --i) {
        const glm::dvec3 place = i % 2 == 0 ? end : 2.0 * centre - end;
        way.push_back(pointAt(place + (shape_.height * i / halves) * up));
        if (i < halves) way.back().arc = turn;
    }
    way.back().pose.tip = end;
    return way;
}

bool LeadFinder::isClear(const std::vector<StrokePoint>& way, double required) const {
    const auto keeps = [&](const PartGuard& guard, double distance) {
        for (std::size_t i = 1; i < way.size(); ++i) {
            const glm::dvec3 &from = way[i - 1].pose.tip, &to = way[i].pose.tip;
            const bool clear =
                way[i].arc ? guard.isClear(Arc{from, to, way[i].arc->centre, way[i].arc->axis, way[i].arc->clockwise},
                                           distance, defaultSampling)
                           : guard.isClear(from, to, distance, defaultSampling);
            if (!clear) return false;
        }
        return true;
    };
    return keeps(guard_, required) && std::ranges::all_of(obstacles_, [&](const auto& obstacle) {
               return keeps(obstacle.first, obstacle.second);
           });
}

} // namespace burin
