// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/stroke_steps.h"

#include "core/geometry/arc.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

Arc arcTo(const StrokePoint& point, const glm::dvec3& from) {
    return {from, point.pose.tip, point.arc->centre, point.arc->axis, point.arc->clockwise};
}

Arc arcTo(const PathStroke& stroke, std::size_t move) {
    return arcTo(stroke.points[move], stroke.points[move - 1].pose.tip);
}

double moveLength(const PathStroke& stroke, std::size_t move) {
    return lengthTo(stroke.points[move], stroke.points[move - 1].pose.tip);
}

glm::dvec3 tipAt(const PathStroke& stroke, const StrokePosition& position) {
    const glm::dvec3& end = stroke.points[position.move].pose.tip;
    if (position.share >= 1.0) return end;
    if (!stroke.points[position.move].arc)
        return glm::mix(stroke.points[position.move - 1].pose.tip, end, position.share);
    const Arc arc = arcTo(stroke, position.move);
    return placeOn(arc, turnOf(arc), position.share);
}

} // namespace

std::vector<StrokeStep> stepsOf(const PathStroke& stroke, double longest) {
    if (stroke.points.empty()) return {};
    std::vector<StrokeStep> steps{{{0, 1.0}, stroke.points.front().pose.tip, 0.0}};
    double at = 0.0;
    for (std::size_t move = 1; move < stroke.points.size(); ++move) {
        const double length = moveLength(stroke, move);
        const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(length / longest)));
        for (std::size_t i = 1; i <= count; ++i) {
            const double share = static_cast<double>(i) / static_cast<double>(count);
            steps.push_back({{move, share}, tipAt(stroke, {move, share}), at + share * length});
        }
        at += length;
    }
    return steps;
}

PathStroke between(const PathStroke& stroke, const StrokePosition& from, const StrokePosition& to) {
    PathStroke part = stroke;
    part.points.clear();
    const bool startsInMove = from.share < 1.0;
    StrokePoint start = stroke.points[startsInMove ? from.move - 1 : from.move];
    start.pose.tip = tipAt(stroke, from);
    start.arc.reset();
    part.points.push_back(start);
    for (std::size_t i = startsInMove ? from.move : from.move + 1; i <= to.move; ++i) {
        part.points.push_back(stroke.points[i]);
        if (i == to.move) part.points.back().pose.tip = tipAt(stroke, to);
    }
    return part;
}

double lengthTo(const StrokePoint& point, const glm::dvec3& from) {
    if (!point.arc) return glm::distance(from, point.pose.tip);
    const Arc arc = arcTo(point, from);
    return lengthOf(arc, turnOf(arc));
}

double lengthOf(const PathStroke& stroke) {
    double length = 0.0;
    for (std::size_t move = 1; move < stroke.points.size(); ++move) length += moveLength(stroke, move);
    return length;
}

Omission omissionOf(const PathStroke& stroke, OmissionReason reason) {
    constexpr double chord = 0.02; // mm, for display
    const auto [first, last] = std::ranges::minmax(stroke.points, {}, &StrokePoint::sample);
    Omission part{reason, stroke.source, first.sample, last.sample, {stroke.points.front().pose.tip}, lengthOf(stroke)};
    std::vector<glm::dvec3> ends;
    for (std::size_t move = 1; move < stroke.points.size(); ++move) {
        ends = {stroke.points[move].pose.tip};
        if (stroke.points[move].arc) flatten(arcTo(stroke, move), chord, ends);
        part.line.insert(part.line.end(), ends.begin(), ends.end());
    }
    return part;
}

} // namespace burin
