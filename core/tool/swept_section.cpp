// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/swept_section.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>

namespace burin {

namespace {

constexpr double levelTriangle = 1e-9;  // mm: a triangle of this height covers no area
constexpr double imageChord = 5e-5;     // mm, between an image's border and its chords
constexpr int mostHalvings = 14;        // of a triangle's height
constexpr double roundingMargin = 3e-4; // mm, for chords and the grid of PlanRegion
constexpr std::size_t groupSize = 48;   // outlines united at once: what they cover in common is gone then
// rad; models have corners and edges in simple directions, which the half-plane of the section has to avoid.
constexpr double oddAngle = 0.739085;

struct RadiusRange {
    double least = 0.0, most = 0.0; ///< mm
};

/// The image of a triangle under (x, y, z) to (distance from the axis, z). Its range of radii is bounded by convex
/// functions of the height.
class TriangleImage {
public:
    explicit TriangleImage(const Triangle& triangle) : low_(triangle[0]), middle_(triangle[1]), high_(triangle[2]) {
        if (low_.z > middle_.z) std::swap(low_, middle_);
        if (middle_.z > high_.z) std::swap(middle_, high_);
        if (low_.z > middle_.z) std::swap(low_, middle_);
    }

    /// Returns an outline of it, anticlockwise; empty for a level triangle.
    PlanRing outline() {
        if (high_.z - low_.z < levelTriangle) return {};
        add(low_.z);
        if (middle_.z > low_.z) addTo(low_.z, middle_.z, 0);
        if (high_.z > middle_.z) addTo(middle_.z, high_.z, 0);
        PlanRing ring;
        for (const auto& [height, radii] : ranges_) ring.emplace_back(radii.most, height);
        // Chords of a convex function lie above it by at most twice what they do in the middle.
        for (auto at = ranges_.rbegin(); at != ranges_.rend(); ++at)
            ring.emplace_back(std::max(0.0, at->second.least - 2.0 * imageChord), at->first);
        return ring;
    }

private:
    RadiusRange at(double height) const {
        const auto on = [&](const glm::dvec3& from, const glm::dvec3& to) {
            return glm::dvec2(glm::mix(from, to, (height - from.z) / (to.z - from.z)));
        };
        const glm::dvec2 one = on(low_, high_);
        const glm::dvec2 other = height <= middle_.z && middle_.z > low_.z ? on(low_, middle_) : on(middle_, high_);
        const glm::dvec2 across = other - one;
        const double square = glm::dot(across, across);
        const double share = square > 0.0 ? std::clamp(-glm::dot(one, across) / square, 0.0, 1.0) : 0.0;
        return {glm::length(one + share * across), std::max(glm::length(one), glm::length(other))};
    }
    void add(double height) { ranges_.emplace_back(height, at(height)); }
    /// Adds the ranges above one that was added up to another height.
    void addTo(double from, double to, int halvings) {
        const double half = 0.5 * (from + to);
        const RadiusRange low = at(from), middle = at(half), high = at(to);
        const double off =
            std::max(0.5 * (low.least + high.least) - middle.least, 0.5 * (low.most + high.most) - middle.most);
        if (off > imageChord && halvings < mostHalvings) {
            addTo(from, half, halvings + 1);
            addTo(half, to, halvings + 1);
        } else {
            add(to);
        }
    }

    glm::dvec3 low_, middle_, high_;
    std::vector<std::pair<double, RadiusRange>> ranges_;
};

/// Returns the outlines in which the plane y = 0 cuts a closed mesh, as (x, z). A vertex in the plane counts as beyond
/// it, so that every triangle that is cut is entered over one edge and left over another.
std::vector<PlanRing> planeSection(const TriangleMesh& mesh) {
    using Edge = std::pair<std::uint32_t, std::uint32_t>;
    std::multimap<Edge, Edge> next;
    const auto beyond = [&](std::uint32_t vertex) { return mesh.vertices[vertex].y >= 0.0; };
    for (const auto& corners : mesh.triangles) {
        Edge entered, left;
        int crossed = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = corners[i], to = corners[(i + 1) % 3];
            if (beyond(from) == beyond(to)) continue;
            (beyond(to) ? entered : left) = std::minmax(from, to);
            ++crossed;
        }
        if (crossed == 2) next.emplace(entered, left);
    }
    std::vector<PlanRing> rings;
    while (!next.empty()) {
        PlanRing& ring = rings.emplace_back();
        for (auto at = next.begin(); at != next.end();) {
            const glm::dvec3 &a = mesh.vertices[at->first.first], &b = mesh.vertices[at->first.second];
            const glm::dvec3 place = glm::mix(a, b, a.y / (a.y - b.y));
            ring.emplace_back(place.x, place.z);
            const Edge end = at->second;
            next.erase(at);
            at = next.find(end);
        }
    }
    return rings;
}

/// Returns the region that any of the outlines covers; holes are clockwise. Outlines at the same height are united
/// first: they overlap most, and little is left of their borders.
PlanRegion united(std::vector<PlanRing> rings, const Progress& progress) {
    std::ranges::sort(rings, {}, [](const PlanRing& ring) { return std::pair(ring.front().y, ring.front().x); });
    std::vector<PlanRegion> regions;
    for (std::size_t first = 0; first < rings.size(); first += groupSize) {
        if (progress.cancelled()) return {};
        const std::span<PlanRing> group = std::span(rings).subspan(first, std::min(groupSize, rings.size() - first));
        regions.push_back(filledBy({group.begin(), group.end()}));
    }
    while (regions.size() > 1) {
        std::vector<PlanRegion> larger;
        for (std::size_t i = 0; i < regions.size(); i += 2) {
            if (progress.cancelled()) return {};
            std::vector<PlanRing> both = std::move(regions[i].rings);
            if (i + 1 < regions.size())
                both.insert(both.end(), regions[i + 1].rings.begin(), regions[i + 1].rings.end());
            larger.push_back(filledBy(both));
        }
        regions = std::move(larger);
    }
    return regions.empty() ? PlanRegion{} : std::move(regions.front());
}

} // namespace

PlanRegion sweptSection(const TriangleMesh& mesh, const Progress& progress) {
    TriangleMesh turned = mesh;
    const double cosine = std::cos(oddAngle), sine = std::sin(oddAngle);
    for (glm::dvec3& v : turned.vertices) v = {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y, v.z};
    const PlanRegion plane = filledBy(planeSection(turned));
    const PlanBounds bounds = boundsOf(plane);
    PlanRegion half = without(plane, rectangle(bounds.low - 1.0, {0.0, bounds.high.y + 1.0}));
    std::vector<PlanRing> images;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        if (PlanRing outline = TriangleImage(cornersOf(mesh, i)).outline(); !outline.empty())
            images.push_back(std::move(outline));
    return grown(joined(half, united(std::move(images), progress)), roundingMargin, roundingMargin);
}

} // namespace burin
