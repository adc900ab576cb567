// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/draped_area.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr double finestDrape = 0.3;  // mm between points
constexpr double mostPlaces = 2000;  // of the outlines of an area, and of its hatching
constexpr double hatchLines = 40;    // across an area
constexpr double closestHatch = 1.5; // mm

/// Projects lines in plan onto a part.
class Drape {
public:
    Drape(const MeshDistance& part, double step) : part_(part), step_(step) {}

    glm::dvec3 at(const glm::dvec2& place) const {
        const Box box = part_.bounds();
        const Ray ray{{place, box.high.z + 1.0}, {0.0, 0.0, -1.0}};
        const std::optional<TriangleHit> hit = part_.hit(ray);
        return {place, hit ? ray.origin.z - hit->distance : box.low.z};
    }
    /// Without its first point.
    void add(const glm::dvec2& from, const glm::dvec2& to, std::vector<glm::dvec3>& line) const {
        const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / step_)));
        for (int i = 1; i <= steps; ++i) line.push_back(at(glm::mix(from, to, static_cast<double>(i) / steps)));
    }

private:
    const MeshDistance& part_;
    double step_;
};

double lengthOf(const PlanRegion& area) {
    double length = 0.0;
    for (const PlanRing& ring : area.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) length += glm::distance(ring[i], ring[(i + 1) % ring.size()]);
    return length;
}

/// The intersections of a line along x with a region's border, in order.
std::vector<double> crossings(const PlanRegion& area, double y) {
    std::vector<double> found;
    for (const PlanRing& ring : area.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
            if ((a.y > y) != (b.y > y)) found.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
        }
    std::ranges::sort(found);
    return found;
}

} // namespace

PlaceChains drapedOutlines(const PlanRegion& area, const MeshDistance& part) {
    const Drape drape(part, std::max(finestDrape, lengthOf(area) / mostPlaces));
    PlaceChains lines;
    for (const PlanRing& ring : area.rings) {
        std::vector<glm::dvec3>& line = lines.emplace_back();
        line.push_back(drape.at(ring.front()));
        for (std::size_t i = 0; i < ring.size(); ++i) drape.add(ring[i], ring[(i + 1) % ring.size()], line);
    }
    return lines;
}

PlaceChains drapedArea(const PlanRegion& area, const MeshDistance& part) {
    PlaceChains lines = drapedOutlines(area, part);
    const PlanBounds bounds = boundsOf(area);
    const double apart = std::max(closestHatch, (bounds.high.y - bounds.low.y) / hatchLines);
    const double spread = (bounds.high.x - bounds.low.x) * (bounds.high.y - bounds.low.y) / apart;
    const Drape drape(part, std::max(finestDrape, spread / mostPlaces));
    for (double y = bounds.low.y + 0.5 * apart; y < bounds.high.y; y += apart) {
        const std::vector<double> ends = crossings(area, y);
        for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
            std::vector<glm::dvec3>& line = lines.emplace_back();
            line.push_back(drape.at({ends[i], y}));
            drape.add({ends[i], y}, {ends[i + 1], y}, line);
        }
    }
    return lines;
}

} // namespace burin
