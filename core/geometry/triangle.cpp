// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/triangle.h"

#include <limits>

namespace burin {

namespace {

double squared(const glm::dvec3& v) noexcept {
    return glm::dot(v, v);
}

TrianglePoint closestOnEdge(const Triangle& t, int edge, const glm::dvec3& p) noexcept {
    const int next = (edge + 1) % 3;
    const glm::dvec3& from = t[static_cast<std::size_t>(edge)];
    const glm::dvec3& to = t[static_cast<std::size_t>(next)];
    const glm::dvec3 along = to - from;
    const double length = squared(along), part = glm::dot(p - from, along);
    if (!(part > 0.0)) return {from, cornerFeature(edge)};
    if (part >= length) return {to, cornerFeature(next)};
    return {from + along * (part / length), edgeFeature(edge)};
}

TrianglePoint closestOnOutline(const Triangle& t, const glm::dvec3& p) noexcept {
    TrianglePoint best;
    double least = std::numeric_limits<double>::infinity();
    for (int edge = 0; edge < 3; ++edge) {
        const TrianglePoint candidate = closestOnEdge(t, edge, p);
        const double distance = squared(candidate.point - p);
        if (distance < least) {
            least = distance;
            best = candidate;
        }
    }
    return best;
}

} // namespace

// By Voronoi regions, as in C. Ericson, Real-Time Collision Detection (2005), section 5.1.5.
TrianglePoint closestOnTriangle(const Triangle& t, const glm::dvec3& p) noexcept {
    const glm::dvec3 ab = t[1] - t[0], ac = t[2] - t[0];
    const glm::dvec3 ap = p - t[0];
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0.0 && d2 <= 0.0) return {t[0], TriangleFeature::cornerA};

    const glm::dvec3 bp = p - t[1];
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0.0 && d4 <= d3) return {t[1], TriangleFeature::cornerB};

    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 && d1 > d3) return {t[0] + ab * (d1 / (d1 - d3)), TriangleFeature::edgeAB};

    const glm::dvec3 cp = p - t[2];
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0.0 && d5 <= d6) return {t[2], TriangleFeature::cornerC};

    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 && d2 > d6) return {t[0] + ac * (d2 / (d2 - d6)), TriangleFeature::edgeCA};

    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 >= d3 && d5 >= d6 && (d4 - d3) + (d5 - d6) > 0.0)
        return {t[1] + (t[2] - t[1]) * ((d4 - d3) / ((d4 - d3) + (d5 - d6))), TriangleFeature::edgeBC};

    const double sum = va + vb + vc;
    // The regions of a sliver are lost in rounding: its outline then contains the result.
    if (!(sum > 1e-14 * squared(ab) * squared(ac))) return closestOnOutline(t, p);
    return {t[0] + ab * (vb / sum) + ac * (vc / sum), TriangleFeature::face};
}

} // namespace burin
