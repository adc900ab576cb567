// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/deviation_surface.h"

#include "core/base/parallel.h"
#include "ui/scene/edge_halving.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

constexpr double mostTriangles = 200'000.0;
constexpr double trianglesInSquare = 4.7; // that remain per square of the longest edge after halving

/// All bodies in one mesh.
ShadedMesh shadedPart(const Model& part) {
    ShadedMesh all;
    for (const Body& body : part.bodies) {
        const ShadedMesh mesh = shaded(body.mesh, creaseAngle);
        const auto offset = static_cast<std::uint32_t>(all.points.size());
        all.points.insert(all.points.end(), mesh.points.begin(), mesh.points.end());
        all.normals.insert(all.normals.end(), mesh.normals.begin(), mesh.normals.end());
        for (const std::uint32_t corner : mesh.triangles) all.triangles.push_back(offset + corner);
    }
    return all;
}

double areaOf(const ShadedMesh& mesh) {
    double area = 0.0;
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
        const glm::dvec3 a = mesh.points[mesh.triangles[i]], b = mesh.points[mesh.triangles[i + 1]],
                         c = mesh.points[mesh.triangles[i + 2]];
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return area;
}

/// Sets the colours of the points. @return which of them have a value
std::vector<std::uint8_t> colourPoints(DeviationSurface& surface, const DeviationPicture& picture, double spacing) {
    const DeviationMap map(*picture.samples, spacing);
    const DeviationScale scale(picture.tolerance);
    const std::size_t count = surface.mesh.points.size();
    std::vector<std::uint8_t> measured(count, 0);
    surface.colours.assign(count, unmeasuredColour);
    constexpr std::size_t grain = 1024;
    parallelIntervals(std::size_t{0}, count, grain, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            const auto sample = map.at(surface.mesh.points[i], surface.mesh.normals[i]);
            if (!sample || bandOf(*sample, picture.tolerance) == DeviationBand::unreachable) continue;
            measured[i] = 1;
            surface.colours[i] = scale.colourOf(deviationOf(*sample));
        }
    });
    return measured;
}

/// Removes the triangles with more unmeasured than measured corners from the mesh. A corner at the border gets the
/// colour of a measured neighbour, so that no value fades into grey.
void partUnmeasured(DeviationSurface& surface, const std::vector<std::uint8_t>& measured) {
    std::vector<std::uint32_t> all;
    all.swap(surface.mesh.triangles);
    for (std::size_t i = 0; i + 2 < all.size(); i += 3) {
        const std::array<std::uint32_t, 3> corners{all[i], all[i + 1], all[i + 2]};
        const auto known = std::ranges::count_if(corners, [&](std::uint32_t c) { return measured[c] != 0; });
        auto& into = known >= 2 ? surface.mesh.triangles : surface.unmeasured;
        into.insert(into.end(), corners.begin(), corners.end());
        if (known != 2) continue;
        const std::uint32_t from = measured[corners[0]] != 0 ? corners[0] : corners[1];
        for (const std::uint32_t corner : corners)
            if (measured[corner] == 0) surface.colours[corner] = surface.colours[from];
    }
}

} // namespace

ShadedMesh divided(ShadedMesh mesh, double edge) {
    const auto tooLong = [&mesh, square = static_cast<float>(edge * edge)](std::uint32_t a, std::uint32_t b) {
        const glm::vec3 along = mesh.points[b] - mesh.points[a];
        return glm::dot(along, along) > square;
    };
    const auto addMiddle = [&mesh](std::uint32_t a, std::uint32_t b) {
        const glm::vec3 normal = middleNormal(mesh.normals[a], mesh.normals[b]);
        mesh.points.push_back(0.5F * (mesh.points[a] + mesh.points[b]));
        mesh.normals.push_back(normal);
        return static_cast<std::uint32_t>(mesh.points.size() - 1);
    };
    while (EdgeHalving(mesh.points, mesh.triangles, tooLong, addMiddle).run()) {
    }
    return mesh;
}

DeviationSurface deviationSurface(const Model& part, const DeviationPicture& picture) {
    DeviationSurface surface;
    surface.mesh = shadedPart(part);
    const double spacing =
        std::max(picture.spacing, std::sqrt(trianglesInSquare * areaOf(surface.mesh) / mostTriangles));
    surface.mesh = divided(std::move(surface.mesh), spacing);
    partUnmeasured(surface, colourPoints(surface, picture, spacing));
    return surface;
}

} // namespace burin
