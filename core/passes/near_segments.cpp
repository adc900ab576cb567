// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/near_segments.h"

#include "core/geometry/segment.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double mostSquaresAsked = 8.0; // along a side: beyond, all segments are looked at

} // namespace

void NearSegments::add(const glm::dvec2& from, const glm::dvec2& to) {
    const auto index = static_cast<std::uint32_t>(segments_.size());
    segments_.emplace_back(from, to);
    const int pieces = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / edge_)));
    for (int piece = 0; piece < pieces; ++piece) {
        const glm::ivec2 first = squareAt(glm::mix(from, to, static_cast<double>(piece) / pieces));
        const glm::ivec2 last = squareAt(glm::mix(from, to, static_cast<double>(piece + 1) / pieces));
        for (int y = std::min(first.y, last.y); y <= std::max(first.y, last.y); ++y)
            for (int x = std::min(first.x, last.x); x <= std::max(first.x, last.x); ++x) {
                std::vector<std::uint32_t>& square = squares_[squareOf({x, y})];
                if (square.empty() || square.back() != index) square.push_back(index);
            }
    }
}

void NearSegments::addRing(const PlanRing& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) add(ring[i], ring[(i + 1) % ring.size()]);
}

template <class Visit>
bool NearSegments::visitNear(const glm::dvec2& place, double distance, const Visit& visit) const {
    if (2.0 * distance > mostSquaresAsked * edge_)
        return std::ranges::any_of(segments_, [&](const auto& each) { return visit(each.first, each.second); });
    const glm::ivec2 low = squareAt(place - distance), high = squareAt(place + distance);
    for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) {
            const auto square = squares_.find(squareOf({x, y}));
            if (square == squares_.end()) continue;
            for (const std::uint32_t i : square->second)
                if (visit(segments_[i].first, segments_[i].second)) return true;
        }
    return false;
}

bool NearSegments::anyWithin(const glm::dvec2& place, double distance) const noexcept {
    return visitNear(place, distance, [&](const glm::dvec2& from, const glm::dvec2& to) {
        return distanceToSegment(place, from, to) < distance;
    });
}

std::optional<glm::dvec2> NearSegments::nearestWithin(const glm::dvec2& place, double distance) const noexcept {
    std::optional<glm::dvec2> found;
    double least = distance;
    visitNear(place, distance, [&](const glm::dvec2& from, const glm::dvec2& to) {
        const glm::dvec2 on = nearestOnSegment(place, from, to);
        if (const double far = glm::distance(place, on); far < least) {
            least = far;
            found = on;
        }
        return false;
    });
    return found;
}

} // namespace burin
