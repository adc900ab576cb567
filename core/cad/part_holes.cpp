// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/part_holes.h"

#include <algorithm>

namespace burin {

namespace {

std::vector<Triangle> trianglesOf(const Model& part) {
    std::vector<Triangle> triangles;
    for (const Body& body : part.bodies)
        for (const auto& corners : body.mesh.triangles)
            triangles.push_back(
                {body.mesh.vertices[corners[0]], body.mesh.vertices[corners[1]], body.mesh.vertices[corners[2]]});
    return triangles;
}

} // namespace

std::vector<UprightHole> uprightHoles(const Model& part) {
    return uprightHoles(trianglesOf(part));
}

std::vector<UprightHole> uprightStuds(const Model& part) {
    return uprightStuds(trianglesOf(part));
}

std::vector<HoleSize> sizesOf(const std::vector<UprightHole>& holes) {
    constexpr double same = 0.01; // mm
    std::vector<double> diameters;
    for (const UprightHole& hole : holes) diameters.push_back(2.0 * hole.radius);
    std::ranges::sort(diameters);
    std::vector<HoleSize> sizes;
    for (const double diameter : diameters) {
        if (sizes.empty() || diameter - sizes.back().diameter > same) sizes.push_back({diameter, 0});
        ++sizes.back().count;
    }
    return sizes;
}

} // namespace burin
