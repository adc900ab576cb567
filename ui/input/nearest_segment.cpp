// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/input/nearest_segment.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

double distanceToLine(const QPointF& place, const QPointF& from, const QPointF& to) {
    const QPointF along = to - from;
    const double square = QPointF::dotProduct(along, along);
    const double share = square > 0.0 ? std::clamp(QPointF::dotProduct(place - from, along) / square, 0.0, 1.0) : 0.0;
    const QPointF off = place - (from + share * along);
    return std::hypot(off.x(), off.y());
}

} // namespace

std::optional<std::size_t> nearestSegment(const QPointF& pointer, std::size_t count,
                                          const std::function<std::pair<glm::dvec3, glm::dvec3>(std::size_t)>& ends,
                                          const Appearance& appearance) {
    double nearest = pointerReach;
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < count; ++i) {
        const auto [from, to] = ends(i);
        const double distance = distanceToLine(pointer, appearance(from), appearance(to));
        if (!(distance < nearest)) continue; // nor where a place is nowhere
        nearest = distance;
        found = i;
    }
    return found;
}

} // namespace burin
