// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/deviation_surface.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

namespace burin {
namespace {

constexpr double mostTriangles = 200'000.0;
constexpr double trianglesInSquare = 4.7; // that halving leaves in the square of the longest edge

/// One round of halving: every edge that is too long gets a point in its middle.
class EdgeHalving {
public:
    EdgeHalving(ShadedMesh& mesh, double edge) : mesh_(mesh), square_(static_cast<float>(edge * edge)) {}

    /// @return whether there was an edge to be halved
    bool run() {
        std::vector<std::uint32_t> whole;
        whole.swap(mesh_.triangles);
        mesh_.triangles.reserve(2 * whole.size());
        for (std::size_t i = 0; i + 2 < whole.size(); i += 3) divide({whole[i], whole[i + 1], whole[i + 2]});
        return !middles_.empty();
    }

private:
    using Corners = std::array<std::uint32_t, 3>;

    std::optional<std::uint32_t> middleOf(std::uint32_t a, std::uint32_t b) {
        const glm::vec3 along = mesh_.points[b] - mesh_.points[a];
        if (!(glm::dot(along, along) > square_)) return std::nullopt;
        const std::uint64_t key = static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
        const auto [place, isNew] = middles_.try_emplace(key, static_cast<std::uint32_t>(mesh_.points.size()));
        if (isNew) {
            const glm::vec3 normal = mesh_.normals[a] + mesh_.normals[b];
            const float length = glm::length(normal);
            mesh_.points.push_back(0.5F * (mesh_.points[a] + mesh_.points[b]));
            mesh_.normals.push_back(length > 0.0F ? normal / length : mesh_.normals[a]);
        }
        return place->second;
    }

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh_.triangles.insert(mesh_.triangles.end(), {a, b, c});
    }

    void divide(const Corners& corner) {
        std::array<std::optional<std::uint32_t>, 3> middle; // of the edge from each corner to the next
        for (std::size_t i = 0; i < 3; ++i) middle[i] = middleOf(corner[i], corner[(i + 1) % 3]);
        const auto halved = std::ranges::count_if(middle, [](const auto& m) { return m.has_value(); });
        if (halved == 0) return add(corner[0], corner[1], corner[2]);
        if (halved == 3) {
            for (std::size_t i = 0; i < 3; ++i) add(corner[i], *middle[i], *middle[(i + 2) % 3]);
            return add(*middle[0], *middle[1], *middle[2]);
        }
        // Turned so that the first edge is halved, and where there are two, the second one, too.
        std::size_t first = 0;
        while (!middle[first] || (halved == 2 && !middle[(first + 1) % 3])) ++first;
        const std::uint32_t a = corner[first], b = corner[(first + 1) % 3], c = corner[(first + 2) % 3];
        const std::uint32_t ab = *middle[first];
        add(a, ab, c);
        if (halved == 1) return add(ab, b, c);
        const std::uint32_t bc = *middle[(first + 1) % 3];
        add(ab, b, bc);
        add(ab, bc, c);
    }

    ShadedMesh& mesh_;
    float square_; ///< mm², of the longest edge that stays
    std::unordered_map<std::uint64_t, std::uint32_t> middles_;
};

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

/// Colours of the points. @return which of them have a value
std::vector<std::uint8_t> colourPoints(DeviationSurface& surface, const DeviationPicture& picture, double spacing) {
    const DeviationMap map(*picture.samples, spacing);
    const DeviationScale scale(picture.tolerance);
    const std::size_t count = surface.mesh.points.size();
    std::vector<std::uint8_t> measured(count, 0);
    surface.colours.assign(count, unmeasuredColour);
    constexpr std::size_t grain = 1024;
    parallelStretches(std::size_t{0}, count, grain, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            const auto sample = map.at(surface.mesh.points[i], surface.mesh.normals[i]);
            if (!sample || bandOf(*sample, picture.tolerance) == DeviationBand::unreachable) continue;
            measured[i] = 1;
            surface.colours[i] = scale.colourOf(deviationOf(*sample));
        }
    });
    return measured;
}

/// Takes the triangles with more unmeasured corners than measured ones out of the mesh. A corner at the border gets the
/// colour of a measured neighbour, as no value fades into grey.
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
    while (EdgeHalving(mesh, edge).run()) {
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
