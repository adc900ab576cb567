// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/area.h"

#include <algorithm>

namespace burin {

bool holds(const Area& area, const glm::dvec3& place) noexcept {
    if (area.outline.size() < 3 || place.z < area.low || place.z > area.high) return false;
    bool inside = false;
    for (std::size_t i = 0, before = area.outline.size() - 1; i < area.outline.size(); before = i++) {
        const glm::dvec3 &a = area.outline[i], &b = area.outline[before];
        if ((a.y > place.y) == (b.y > place.y)) continue;
        if (place.x < a.x + (b.x - a.x) * (place.y - a.y) / (b.y - a.y)) inside = !inside;
    }
    return inside;
}

std::vector<double> crossings(const Area& area, const glm::dvec3& from, const glm::dvec3& to) {
    std::vector<double> shares;
    const auto add = [&](double share) {
        if (share > 1e-9 && share < 1.0 - 1e-9) shares.push_back(share);
    };
    const glm::dvec3 way = to - from;
    for (std::size_t i = 0, before = area.outline.size() - 1; i < area.outline.size(); before = i++) {
        const glm::dvec3 &a = area.outline[before], edge = area.outline[i] - a, apart = a - from;
        const double across = way.x * edge.y - way.y * edge.x;
        if (across == 0.0) continue;
        const double onEdge = (apart.x * way.y - apart.y * way.x) / across;
        if (onEdge >= 0.0 && onEdge <= 1.0) add((apart.x * edge.y - apart.y * edge.x) / across);
    }
    if (way.z != 0.0) {
        add((area.low - from.z) / way.z);
        add((area.high - from.z) / way.z);
    }
    std::ranges::sort(shares);
    const auto same = std::ranges::unique(shares, [](double a, double b) { return b - a < 1e-9; });
    shares.erase(same.begin(), same.end());
    return shares;
}

} // namespace burin
