// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/hollow_tip.h"

#include "core/base/units.h"
#include "core/tool/swept_section.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr double touchingOutline = 3e-4; // mm, between a hollow that is open to the outside and the profile
constexpr double measuredFrom = 1e-3;    // mm, from the border of a hollow: what is narrower doesn't count for its size
constexpr double cornerTolerance = 2e-4; // mm, of rounded corners
constexpr double leastSimplified = 2e-4; // mm
constexpr std::size_t wantedCorners = 96; // of a section; more cost time where loads are computed
constexpr std::size_t fewestFacets = 32;

/// The profile as a polygon; arcs by their chords.
PlanRegion regionOf(std::span<const ProfileElement> profile) {
    PlanRing ring{{0.0, 0.0}};
    for (const ProfileElement& element : profile) ring.emplace_back(element.radius, element.height);
    ring.emplace_back(0.0, ring.back().y);
    return {{std::move(ring)}};
}

PlanRegion withMirrorImage(const PlanRegion& region) {
    PlanRegion mirrored = region;
    for (PlanRing& ring : mirrored.rings)
        for (glm::dvec2& corner : ring) corner.x = -corner.x;
    return joined(region, mirrored);
}

PlanRegion regionOf(const PlanPiece& piece) {
    PlanRegion region{{piece.border}};
    region.rings.insert(region.rings.end(), piece.holes.begin(), piece.holes.end());
    return region;
}

std::size_t cornersOf(const PlanRegion& region) {
    std::size_t count = 0;
    for (const PlanRing& ring : region.rings) count += ring.size();
    return count;
}

double distanceTo(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& place) {
    const glm::dvec2 along = to - from;
    const double square = glm::dot(along, along);
    const double share = square > 0.0 ? std::clamp(glm::dot(place - from, along) / square, 0.0, 1.0) : 0.0;
    return glm::distance(place, from + share * along);
}

/// Whether a ring touches the profile's lines: face, side and shoulders, but not its upper end.
bool touchesOutline(const PlanRing& ring, std::span<const ProfileElement> profile) {
    const double top = profile.back().height;
    return std::ranges::any_of(ring, [&](const glm::dvec2& corner) {
        const glm::dvec2 place(std::abs(corner.x), corner.y);
        if (place.y > top - touchingOutline) return false;
        glm::dvec2 from(0.0);
        for (const ProfileElement& element : profile) {
            const glm::dvec2 to(element.radius, element.height);
            if (distanceTo(from, to, place) < touchingOutline) return true;
            from = to;
        }
        return false;
    });
}

/// Returns those parts of the free space within the profile that are open to the outside and wide enough.
PlanRegion hollowsIn(const PlanRegion& free, std::span<const ProfileElement> profile, double narrowest) {
    PlanRegion hollows;
    for (const PlanPiece& piece : piecesOf(free)) {
        if (!touchesOutline(piece.border, profile)) continue;
        const PlanRegion whole = regionOf(piece), core = grown(whole, -0.5 * narrowest, cornerTolerance);
        if (core.empty()) continue;
        // Without the gap along the profile that its tolerance leaves, but with sharp corners.
        const PlanRegion gap = without(whole, grown(core, narrowest, cornerTolerance));
        const PlanRegion hollow = without(whole, gap);
        hollows.rings.insert(hollows.rings.end(), hollow.rings.begin(), hollow.rings.end());
    }
    return hollows;
}

std::size_t facetsOf(double widest, std::size_t corners) {
    const double half = std::acos(std::max(-1.0, 1.0 - revolvedChord / widest));
    const double most = static_cast<double>(ToolSolid::mostTriangles / (2 * corners));
    return std::max(fewestFacets, static_cast<std::size_t>(std::min(std::ceil(pi / half), most)));
}

/// Adds the surface that a ring sweeps in a turn; the solid lies on the left of the ring.
void addRevolved(const PlanRing& ring, std::size_t facets, TriangleMesh& mesh) {
    std::vector<std::uint32_t> first; // vertex of each corner; the others of its circle follow
    for (const glm::dvec2& corner : ring) {
        first.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
        for (std::size_t i = 0; i < (corner.x > 0.0 ? facets : 1); ++i) {
            const double angle = 2.0 * pi * static_cast<double>(i) / static_cast<double>(facets);
            mesh.vertices.emplace_back(corner.x * std::cos(angle), corner.x * std::sin(angle), corner.y);
        }
    }
    for (std::size_t corner = 0; corner < ring.size(); ++corner) {
        const std::size_t other = (corner + 1) % ring.size();
        const auto at = [&](std::size_t which, std::size_t facet) {
            return first[which] + (ring[which].x > 0.0 ? static_cast<std::uint32_t>(facet % facets) : 0U);
        };
        for (std::size_t i = 0; i < facets; ++i) {
            if (ring[corner].x > 0.0) mesh.triangles.push_back({at(corner, i), at(corner, i + 1), at(other, i + 1)});
            if (ring[other].x > 0.0) mesh.triangles.push_back({at(corner, i), at(other, i + 1), at(other, i)});
        }
    }
}

double widestOf(const PlanRegion& section) {
    return std::max(boundsOf(section).high.x, 1e-3);
}

} // namespace

std::optional<HollowSection> hollowSection(const TriangleMesh& mesh, std::span<const ProfileElement> profile,
                                           double narrowest, const Progress& progress) {
    const PlanRegion swept = sweptSection(mesh, progress), whole = regionOf(profile);
    if (progress.cancelled()) return std::nullopt;
    for (double tolerance = leastSimplified;; tolerance *= 2.0) {
        const PlanRegion solid = cleaned(grown(swept, tolerance, cornerTolerance), tolerance);
        const PlanRegion free = without(withMirrorImage(whole), withMirrorImage(solid));
        const PlanRegion hollows = hollowsIn(free, profile, narrowest);
        if (hollows.empty()) return std::nullopt;
        HollowSection result{without(whole, hollows), 0.0};
        const double chord =
            widestOf(result.section) *
            (1.0 - std::cos(pi / static_cast<double>(facetsOf(widestOf(result.section), cornersOf(result.section)))));
        result.excess = std::max(narrowest, sweptSectionExcess + 2.0 * tolerance + chord);
        if (cornersOf(result.section) <= wantedCorners || tolerance > narrowest) return result;
    }
}

ToolSolid turningSolid(PlanRegion section, std::span<const ProfileElement> profile) {
    ToolSolid solid;
    const std::size_t corners = cornersOf(section);
    if (corners >= 3 && corners <= ToolSolid::mostCorners && !profile.empty()) {
        const std::size_t facets = facetsOf(widestOf(section), corners);
        for (const PlanRing& ring : oriented(section).rings) addRevolved(ring, facets, solid.flutes);
        const PlanRegion hollow = grown(without(regionOf(profile), section), -measuredFrom, cornerTolerance);
        if (!hollow.empty()) {
            solid.hollowDepth = boundsOf(hollow).high.y + measuredFrom;
            solid.hollowWidth = 2.0 * (boundsOf(hollow).high.x + measuredFrom);
        }
    }
    solid.section = std::move(section);
    return solid;
}

double boreAt(const ToolSolid& solid, double height) {
    std::size_t crossings = 0;
    double nearest = widestOf(solid.section);
    for (const PlanRing& ring : solid.section.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
            if ((a.y > height) == (b.y > height)) continue;
            const double radius = a.x + (b.x - a.x) * (height - a.y) / (b.y - a.y);
            if (!(radius > 0.0)) continue;
            ++crossings;
            nearest = std::min(nearest, radius);
        }
    return crossings % 2 == 1 ? 0.0 : nearest;
}

} // namespace burin
