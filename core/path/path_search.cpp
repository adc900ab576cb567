// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/path_search.h"

#include "core/geometry/arc.h"
#include "core/geometry/segment.h"
#include "core/path/hand_interval.h"

#include <algorithm>
#include <limits>

namespace burin {

namespace {

constexpr double searchChord = 0.02; // mm

/// The points of a move after its start: its end, or points along its arc.
std::vector<glm::dvec3> lineOf(const PathPoint& from, const PathPoint& to) {
    std::vector<glm::dvec3> line{to.pose.tip};
    if (to.arc)
        flatten({from.pose.tip, to.pose.tip, to.arc->centre, to.arc->axis, to.arc->clockwise}, searchChord, line);
    return line;
}

double distanceToBox(const Box& box, const glm::dvec3& place) {
    return glm::distance(place, glm::clamp(place, box.low, box.high));
}

} // namespace

PlaceOnPath nearestOnMove(const PathPoint& from, const PathPoint& to, const glm::dvec3& place) {
    const std::vector<glm::dvec3> line = lineOf(from, to);
    PlaceOnPath nearest;
    nearest.distance = std::numeric_limits<double>::infinity();
    glm::dvec3 begin = from.pose.tip;
    for (std::size_t k = 0; k < line.size(); ++k) {
        const glm::dvec3 at = nearestOnSegment(place, begin, line[k]);
        const double distance = glm::distance(place, at), chord = glm::distance(begin, line[k]);
        if (distance < nearest.distance) {
            const double share = chord > 0.0 ? glm::distance(begin, at) / chord : 0.0;
            nearest = {0, (static_cast<double>(k) + share) / static_cast<double>(line.size()), at, distance};
        }
        begin = line[k];
    }
    return nearest;
}

bool canBeTaken(const PathPoint& point) noexcept {
    return hasMoment(point) && point.kind != MoveKind::rapid;
}

PathSearch::PathSearch(const std::vector<PathPoint>& points) : points_(points) {
    if (points.size() < 2) return;
    blocks_.resize((points.size() - 2) / blockSize + 1);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        Box& block = blocks_[i / blockSize];
        const bool begins = canBeTaken(points[i]), ends = canBeTaken(points[i + 1]);
        if (begins) block.include(points[i].pose.tip);
        if (ends) block.include(points[i + 1].pose.tip);
        if (begins && ends && points[i + 1].arc)
            for (const glm::dvec3& place : lineOf(points[i], points[i + 1])) block.include(place);
    }
}

/// If only one end of the move can be taken, that end.
std::optional<PlaceOnPath> PathSearch::onPiece(std::size_t piece, const glm::dvec3& place) const {
    const PathPoint &from = points_[piece], &to = points_[piece + 1];
    const bool begins = canBeTaken(from), ends = canBeTaken(to);
    if (!begins && !ends) return std::nullopt;
    PlaceOnPath nearest;
    if (begins && ends)
        nearest = nearestOnMove(from, to, place);
    else
        nearest = {0, ends ? 1.0 : 0.0, (ends ? to : from).pose.tip, glm::distance(place, (ends ? to : from).pose.tip)};
    nearest.piece = piece;
    return nearest;
}

std::optional<PlaceOnPath> PathSearch::nearest(const glm::dvec3& place, double reach) const {
    std::optional<PlaceOnPath> best;
    for (std::size_t block = 0; block < blocks_.size(); ++block) {
        if (blocks_[block].empty() || distanceToBox(blocks_[block], place) > reach) continue;
        const std::size_t end = std::min((block + 1) * blockSize, points_.size() - 1);
        for (std::size_t piece = block * blockSize; piece < end; ++piece) {
            const std::optional<PlaceOnPath> found = onPiece(piece, place);
            if (!found || found->distance > reach) continue;
            reach = found->distance;
            if (!best || found->distance < best->distance) best = found;
        }
    }
    return best;
}

} // namespace burin
