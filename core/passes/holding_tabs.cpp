// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/holding_tabs.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

constexpr double cornerTurn = 20.0 * pi / 180.0; // rad: a smaller turn is not a corner
const double flank = std::tan(30.0 * pi / 180.0);
constexpr int phases = 24;         // shifts of the tabs along an outline that are tried
constexpr double onRunShare = 1.0; // of the diameter: a tab farther from a run than this does not belong to it

/// The distance along a ring to each of its corners, and after them its full length, mm.
std::vector<double> waysAlong(const PlanRing& ring) {
    std::vector<double> ways{0.0};
    for (std::size_t i = 0; i < ring.size(); ++i)
        ways.push_back(ways.back() + glm::distance(ring[i], ring[(i + 1) % ring.size()]));
    return ways;
}

glm::dvec2 placeAt(const PlanRing& ring, const std::vector<double>& ways, double way) {
    const auto next = std::ranges::upper_bound(ways, way);
    const std::size_t i = std::min(static_cast<std::size_t>(next - ways.begin()) - 1, ring.size() - 1);
    const double length = ways[i + 1] - ways[i];
    return glm::mix(ring[i], ring[(i + 1) % ring.size()], length > 0.0 ? (way - ways[i]) / length : 0.0);
}

/// The distances along the ring to its sharp corners, mm.
std::vector<double> cornersOf(const PlanRing& ring, const std::vector<double>& ways) {
    std::vector<double> corners;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 in = ring[i] - ring[(i + ring.size() - 1) % ring.size()];
        const glm::dvec2 out = ring[(i + 1) % ring.size()] - ring[i];
        const double turn = std::abs(std::atan2(in.x * out.y - in.y * out.x, glm::dot(in, out)));
        if (turn > cornerTurn) corners.push_back(ways[i]);
    }
    return corners;
}

} // namespace

void HoldingTabs::place(const PlanRegion& room) {
    places_.clear();
    for (const PlanRing& ring : room.rings) {
        const std::vector<double> ways = waysAlong(ring);
        const std::vector<double> corners = cornersOf(ring, ways);
        const double whole = ways.back(), apart = whole / request_.tabs;
        const auto nearest = [&](double shift) {
            double least = std::numeric_limits<double>::infinity();
            for (int i = 0; i < request_.tabs; ++i)
                for (const double corner : corners) {
                    const double way = std::abs(shift + i * apart - corner);
                    least = std::min({least, way, whole - way});
                }
            return least;
        };
        double best = 0.5 * apart;
        for (int phase = 0; phase < phases; ++phase)
            if (const double shift = apart * phase / phases; nearest(shift) > nearest(best)) best = shift;
        for (int i = 0; i < request_.tabs; ++i)
            places_.push_back(placeAt(ring, ways, std::fmod(best + i * apart, whole)));
    }
}

TipLine HoldingTabs::over(const LevelRun& run, double level) const {
    TipLine tips;
    for (const glm::dvec2& place : run.places) tips.emplace_back(place, level);
    if (!reach(level)) return tips;
    std::vector<double> ways{0.0};
    for (std::size_t i = 1; i < run.places.size(); ++i)
        ways.push_back(ways.back() + glm::distance(run.places[i - 1], run.places[i]));
    // The cutter reaches half of its width into the tab from both ends, and a point may lie short of the start of the
    // flank.
    const double half = 0.5 * (request_.tabWidth + diameter_) + spacing_;
    for (const glm::dvec2& tab : places_) {
        const auto middle = std::ranges::min_element(
            run.places, {}, [&](const glm::dvec2& place) { return glm::distance(place, tab); });
        if (glm::distance(*middle, tab) > onRunShare * diameter_) continue;
        const double at = ways[static_cast<std::size_t>(middle - run.places.begin())];
        for (std::size_t i = 0; i < tips.size(); ++i) {
            double way = std::abs(ways[i] - at);
            if (run.closed) way = std::min(way, ways.back() - way);
            tips[i].z = std::max(tips[i].z, top_ - flank * std::max(0.0, way - half));
        }
    }
    return tips;
}

} // namespace burin
