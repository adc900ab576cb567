// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/rational_spline.h"

#include "core/geometry/segment.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {
namespace {

constexpr int highestDegree = 25;
constexpr std::size_t mostControls = 100'000;

void halve(const RationalSpline& spline, double first, const glm::dvec2& from, double last, const glm::dvec2& to,
           double chord, int depth, std::vector<glm::dvec2>& places) {
    constexpr int deepest = 14;
    const auto at = [&](double share) { return pointOn(spline, first + share * (last - first)); };
    const glm::dvec2 middle = at(0.5);
    const bool straight = distanceToSegment(middle, from, to) <= chord &&
                          distanceToSegment(at(0.25), from, to) <= chord &&
                          distanceToSegment(at(0.75), from, to) <= chord;
    if (straight || depth == deepest) {
        places.push_back(to);
        return;
    }
    halve(spline, first, from, 0.5 * (first + last), middle, chord, depth + 1, places);
    halve(spline, 0.5 * (first + last), middle, last, to, chord, depth + 1, places);
}

} // namespace

bool isValid(const RationalSpline& spline) noexcept {
    const std::size_t count = spline.controls.size();
    if (spline.degree < 1 || spline.degree > highestDegree || count > mostControls) return false;
    const auto degree = static_cast<std::size_t>(spline.degree);
    if (count < degree + 1 || spline.knots.size() != count + degree + 1) return false;
    if (!spline.weights.empty() && spline.weights.size() != count) return false;
    const auto finite = [](double value) { return std::isfinite(value); };
    return std::ranges::all_of(spline.knots, finite) && std::ranges::is_sorted(spline.knots) &&
           std::ranges::all_of(spline.weights, [](double weight) { return weight > 0.0 && std::isfinite(weight); }) &&
           std::ranges::all_of(spline.controls,
                               [&](const glm::dvec2& place) { return finite(place.x) && finite(place.y); }) &&
           spline.knots[degree] < spline.knots[count];
}

glm::dvec2 pointOn(const RationalSpline& spline, double at) {
    const auto degree = static_cast<std::size_t>(spline.degree);
    const auto begin = spline.knots.begin() + spline.degree;
    const auto end = spline.knots.end() - spline.degree - 1;
    // The non-empty span of knots that contains the value.
    auto span = static_cast<std::size_t>(std::upper_bound(begin, end, at) - spline.knots.begin()) - 1;
    while (span > degree && !(spline.knots[span] < spline.knots[span + 1])) --span;
    std::array<glm::dvec3, highestDegree + 1> row; // x w, y w, w
    for (std::size_t i = 0; i <= degree; ++i) {
        const std::size_t control = span - degree + i;
        const double weight = spline.weights.empty() ? 1.0 : spline.weights[control];
        row[i] = {weight * spline.controls[control], weight};
    }
    for (std::size_t level = 1; level <= degree; ++level)
        for (std::size_t i = degree; i >= level; --i) {
            const double low = spline.knots[span - degree + i], high = spline.knots[span + 1 + i - level];
            const double share = high > low ? (at - low) / (high - low) : 0.0;
            row[i] = glm::mix(row[i - 1], row[i], share);
        }
    return glm::dvec2(row[degree]) / row[degree].z;
}

std::vector<glm::dvec2> flattened(const RationalSpline& spline, double chord) {
    const auto degree = static_cast<std::size_t>(spline.degree);
    std::vector<glm::dvec2> places{pointOn(spline, spline.knots[degree])};
    for (std::size_t i = degree; i < spline.controls.size(); ++i) {
        const double first = spline.knots[i], last = spline.knots[i + 1];
        if (!(first < last)) continue;
        constexpr int pieces = 4; // per span, so that no loop within it is missed
        for (int piece = 0; piece < pieces; ++piece) {
            const double from = first + (last - first) * piece / pieces,
                         to = first + (last - first) * (piece + 1) / pieces;
            halve(spline, from, places.back(), to, pointOn(spline, to), chord, 0, places);
        }
    }
    return places;
}

} // namespace burin
