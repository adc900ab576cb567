// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/surface_flux.h"

#include "core/base/units.h"
#include "core/cutting/footprint.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

// So many patches cover a hemisphere or a wall at most; large tools get larger patches.
constexpr double hemispherePatches = 1500.0;
constexpr double wallPatches = 720.0;
constexpr double lookAhead = 1.0; // voxels

int countOf(double length, double spacing) noexcept {
    return std::max(1, static_cast<int>(std::ceil(length / spacing)));
}

} // namespace

SurfaceFlux::SurfaceFlux(const RevolvedPiece& flutes, double edge) : edge_(edge) {
    const double radius = flutes.bottomRadius, corner = flutes.cornerRadius, flat = radius - corner;
    const double spacing = std::max(edge, radius * std::sqrt(2.0 * pi / hemispherePatches));
    const int discs = flat > 0.0 ? countOf(flat, spacing) : 0;
    for (int i = 0; i < discs; ++i)
        addRing({flat * i / discs, flat * (i + 1) / discs, flutes.bottom, flutes.bottom}, spacing);
    const int arcs = corner > 0.0 ? countOf(0.5 * pi * corner, spacing) : 0;
    for (int i = 0; i < arcs; ++i) {
        const double low = 0.5 * pi * i / arcs, high = 0.5 * pi * (i + 1) / arcs;
        addRing({flat + corner * std::sin(low), flat + corner * std::sin(high),
                 flutes.bottom + corner * (1.0 - std::cos(low)), flutes.bottom + corner * (1.0 - std::cos(high))},
                spacing);
    }
    if (flutes.top > flutes.bottom + corner)
        addRing({radius, radius, flutes.bottom + corner, flutes.top},
                std::max(0.5 * edge, 2.0 * pi * radius / wallPatches));
}

/// Cuts a ring into sectors. A sector's integral of the normal: in the plane the chord's normal times the height, along
/// the axis its area seen from above.
void SurfaceFlux::addRing(const Ring& ring, double spacing) {
    const double middle = 0.5 * (ring.innerRadius + ring.outerRadius);
    const int sectors = std::max(12, countOf(2.0 * pi * middle, spacing));
    const double angle = 2.0 * pi / sectors;
    const double sideways = 2.0 * std::sin(0.5 * angle) * middle * (ring.high - ring.low);
    const double down = 0.5 * angle * (ring.outerRadius - ring.innerRadius) * (ring.outerRadius + ring.innerRadius);
    for (int i = 0; i < sectors; ++i) {
        const double cosine = std::cos((i + 0.5) * angle), sine = std::sin((i + 0.5) * angle);
        patches_.push_back({{sideways * cosine, sideways * sine, -down},
                            middle * cosine,
                            middle * sine,
                            ring.low,
                            std::max(ring.high, ring.low + 0.25 * edge_)});
    }
}

void SurfaceFlux::measure(const RunVolume& workpiece, const GapWindow* window, const glm::dvec3& tip,
                          const glm::dvec3& motion, Flux& flux) const noexcept {
    const Grid& grid = workpiece.grid();
    const PropertyList& properties = workpiece.properties();
    const glm::dvec3 probe = tip + motion * (lookAhead * edge_ / glm::length(motion));
    const glm::dvec2 origin = (glm::dvec2(probe) - glm::dvec2(grid.low())) / edge_;
    for (const Patch& patch : patches_) {
        const double swept = glm::dot(patch.area, motion);
        if (swept <= 0.0) continue; // turned away from the motion
        const double u = origin.x + patch.x / edge_, v = origin.y + patch.y / edge_;
        if (!(u >= 0.0 && v >= 0.0 && u < grid.lineCountU() && v < grid.lineCountV())) continue;
        const RunPosition from = grid.toRunPosition(probe.z + patch.low), to = grid.toRunPosition(probe.z + patch.high);
        const double share = swept * (edge_ / unitsPerVoxel) / (patch.high - patch.low);
        const LineIndex line{static_cast<std::int32_t>(u), static_cast<std::int32_t>(v)};
        const auto add = [&](PropertyIndex property, RunPosition start, RunPosition end) {
            if (properties.isProtected(property)) return;
            const double volume = share * (end - start);
            flux.volume[property] += volume;
            flux.total += volume;
            flux.moment += volume * glm::dvec3(tip.x + patch.x, tip.y + patch.y,
                                               0.5 * (grid.toMillimetres(start) + grid.toMillimetres(end)));
        };
        if (from < to) forEachPieceLeft(workpiece, window, line, from, to, add);
    }
}

} // namespace burin
