// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/guides/polyline_tracker.h"

#include <algorithm>
#include <limits>

namespace burin {
namespace {

PolylineFoot footOn(const Polyline& line, std::size_t segment, const glm::dvec3& place) noexcept {
    const glm::dvec3 from = line.points[segment], way = line.points[segment + 1] - from;
    const bool endless = line.ends == PolylineEnds::goOn;
    const double low = endless && segment == 0 ? -std::numeric_limits<double>::max() : 0.0;
    const double high = endless && segment + 1 == line.segments() ? std::numeric_limits<double>::max() : 1.0;
    PolylineFoot foot;
    foot.segment = segment;
    foot.share = std::clamp(glm::dot(place - from, way) / glm::dot(way, way), low, high);
    foot.point = from + foot.share * way;
    foot.distance = glm::length(place - foot.point);
    return foot;
}

/// Replaces a segment by the one after (or before) it; returns false at an end.
bool neighbour(const Polyline& line, bool onwards, std::size_t& segment) noexcept {
    const std::size_t last = line.segments() - 1;
    if (segment != (onwards ? last : 0)) {
        segment = onwards ? segment + 1 : segment - 1;
        return true;
    }
    if (line.ends != PolylineEnds::join) return false;
    segment = onwards ? 0 : last;
    return true;
}

/// Walks from a foot in one direction as long as the distance decreases.
PolylineFoot walked(const Polyline& line, const glm::dvec3& place, PolylineFoot foot, bool onwards,
                    double travel) noexcept {
    for (std::size_t i = 0; i < PolylineTracker::walkedSegments && travel > 0.0; ++i) {
        std::size_t segment = foot.segment;
        if (!neighbour(line, onwards, segment)) break;
        const PolylineFoot next = footOn(line, segment, place);
        if (next.distance > foot.distance) break;
        travel -= glm::length(next.point - foot.point);
        foot = next;
    }
    return foot;
}

PolylineFoot followed(const Polyline& line, const glm::dvec3& place, const PolylineFoot& from, double travel) noexcept {
    const PolylineFoot here = footOn(line, from.segment, place);
    const PolylineFoot onwards = walked(line, place, here, true, travel),
                       back = walked(line, place, here, false, travel);
    return onwards.distance <= back.distance ? onwards : back;
}

} // namespace

const PolylineFoot& PolylineTracker::search(const Polyline& line, const glm::dvec3& place) noexcept {
    const std::size_t segments = line.segments();
    foot_.segment = known_ ? std::min(foot_.segment, segments - 1) : 0;
    known_ = true;
    foot_ = followed(line, place, foot_, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < std::min(searchedSegments, segments); ++i) {
        next_ = next_ + 1 < segments ? next_ + 1 : 0;
        const PolylineFoot other = footOn(line, next_, place);
        if (other.distance < foot_.distance) foot_ = other;
    }
    return foot_;
}

const PolylineFoot& PolylineTracker::follow(const Polyline& line, const glm::dvec3& place, double travel) noexcept {
    foot_.segment = known_ ? std::min(foot_.segment, line.segments() - 1) : 0;
    known_ = true;
    return foot_ = followed(line, place, foot_, travel);
}

} // namespace burin
