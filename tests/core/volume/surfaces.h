// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/volume/surface/surface.h"

#include <map>
#include <utility>

namespace burin::test {

/// The surface of all tiles, one after the other.
inline SurfaceMesh wholeSurface(const VolumeSnapshot& workpiece, const SurfaceDetail& detail) {
    SurfaceExtractor extractor;
    SurfaceMesh whole, piece;
    const glm::ivec2 tiles = surfaceTiles(workpiece.grid());
    for (int v = 0; v < tiles.y; ++v)
        for (int u = 0; u < tiles.x; ++u) {
            extractor.extract(workpiece, {u, v}, detail, piece);
            const auto first = static_cast<std::uint32_t>(whole.points.size());
            whole.points.insert(whole.points.end(), piece.points.begin(), piece.points.end());
            whole.normals.insert(whole.normals.end(), piece.normals.begin(), piece.normals.end());
            whole.properties.insert(whole.properties.end(), piece.properties.begin(), piece.properties.end());
            for (const std::uint32_t corner : piece.triangles) whole.triangles.push_back(first + corner);
        }
    return whole;
}

/// Merges points of different tiles at the same position.
inline TriangleMesh triangleMesh(const SurfaceMesh& surface) {
    TriangleMesh mesh;
    mesh.vertices.assign(surface.points.begin(), surface.points.end());
    for (std::size_t i = 0; i < surface.triangles.size(); i += 3)
        mesh.triangles.push_back({surface.triangles[i], surface.triangles[i + 1], surface.triangles[i + 2]});
    return weldIdenticalVertices(mesh);
}

/// Number of directed edges that are not used as often as their reverse: 0 for a surface without a hole. (Where two
/// sheets touch along an edge, four triangles may share it.)
inline std::size_t countGaps(const TriangleMesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
    for (const auto& triangle : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = triangle[i], to = triangle[(i + 1) % 3];
            balance[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
        }
    std::size_t gaps = 0;
    for (const auto& [edge, sum] : balance) gaps += sum != 0 ? 1 : 0;
    return gaps;
}

/// Fills each scanline where `inside` finds material: `inside(point perpendicular to the runs)` returns an interval
/// along them, mm.
template <class Inside>
void fillLines(RunVolume& volume, PropertyIndex property, Inside inside) {
    const Grid& grid = volume.grid();
    for (std::int32_t v = 0; v < grid.lineCountV(); ++v)
        for (std::int32_t u = 0; u < grid.lineCountU(); ++u) {
            const auto [from, to] = inside(grid.lineCentre({u, v}));
            if (from < to) (void)volume.fillSpan({u, v}, grid.toRunPosition(from), grid.toRunPosition(to), property);
        }
}

/// Centre in x, y, z.
inline void fillSphere(RunVolume& volume, PropertyIndex property, const glm::dvec3& centre, double radius) {
    const Grid& grid = volume.grid();
    const double middle = centre[grid.axisOfRuns()];
    fillLines(volume, property, [&](glm::dvec2 place) {
        const glm::dvec2 across = place - glm::dvec2(centre[grid.axisOfU()], centre[grid.axisOfV()]);
        const double square = radius * radius - glm::dot(across, across);
        const double reach = square > 0.0 ? std::sqrt(square) : 0.0;
        return std::pair(middle - reach, middle + reach);
    });
}

} // namespace burin::test
