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

/// What lies nearer to the eye appears longer, so that halves of the picture are no halves of the piece.
double shareNearest(const QPointF& pointer, const glm::dvec3& from, const glm::dvec3& to,
                    const Appearance& appearance) {
    constexpr int halvings = 24; // a ten-millionth of the piece
    const QPointF along = appearance(to) - appearance(from);
    double low = 0.0, high = 1.0;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        const bool before = QPointF::dotProduct(pointer - appearance(glm::mix(from, to, middle)), along) > 0.0;
        (before ? low : high) = middle;
    }
    constexpr double end = 1e-6;
    return low < end ? 0.0 : high > 1.0 - end ? 1.0 : 0.5 * (low + high);
}

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
