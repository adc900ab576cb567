// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/skirt_depth.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

bool isMaterial(const VolumeSnapshot& workpiece, const glm::dvec3& place) {
    const Grid& grid = workpiece.grid();
    const glm::dvec3 voxel = glm::floor((place - grid.low()) / grid.edge());
    const LineIndex line{static_cast<std::int32_t>(voxel[grid.axisOfU()]),
                         static_cast<std::int32_t>(voxel[grid.axisOfV()])};
    if (!grid.contains(line) || !grid.box().contains(place)) return false;
    const RunPosition position = grid.toRunPosition(place[grid.axisOfRuns()]);
    for (const Segment segment : workpiece.line(line))
        if (segment.end() > position) return segment.property() != airProperty;
    return false;
}

} // namespace

std::vector<float> skirtDepths(const VolumeSnapshot& workpiece, const SurfaceMesh& surface,
                               std::span<const std::uint32_t> rim, float deepest) {
    const double step = workpiece.grid().edge();
    std::vector<float> depths;
    for (const std::uint32_t point : rim) {
        const glm::dvec3 place(surface.points[point]), down = -glm::dvec3(surface.normals[point]);
        double through = step; // the surface itself may be slightly outside the material
        while (through < 2.0 * deepest && isMaterial(workpiece, place + through * down)) through += step;
        depths.push_back(std::min(deepest, static_cast<float>(0.5 * through)));
    }
    return depths;
}

} // namespace burin
