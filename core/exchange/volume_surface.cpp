// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/volume_surface.h"

#include "core/volume/surface/surface.h"

#include <array>
#include <new>
#include <unordered_map>

namespace burin {

namespace {

/// Tiles share the points of their borders bit by bit: each becomes one vertex.
class Welder {
public:
    explicit Welder(VolumeSurface& surface) : surface_(surface) {}

    void add(const SurfaceMesh& tile) {
        std::vector<std::uint32_t> place(tile.points.size());
        for (std::size_t i = 0; i < place.size(); ++i) place[i] = vertexOf(tile.points[i]);
        for (std::size_t corner = 0; corner + 2 < tile.triangles.size(); corner += 3) {
            const std::array<std::uint32_t, 3> triangle{
                place[tile.triangles[corner]], place[tile.triangles[corner + 1]], place[tile.triangles[corner + 2]]};
            if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
            surface_.mesh.triangles.push_back(triangle);
            surface_.materials.push_back(tile.properties[tile.triangles[corner]]);
        }
    }

private:
    struct Hash {
        std::size_t operator()(const std::array<float, 3>& place) const noexcept {
            std::size_t hash = 0;
            for (const float part : place) hash = hash * 1'000'003U ^ std::hash<float>{}(part);
            return hash;
        }
    };
    std::uint32_t vertexOf(const glm::vec3& point) {
        const auto [entry, isNew] =
            known_.try_emplace({point.x, point.y, point.z}, static_cast<std::uint32_t>(surface_.mesh.vertices.size()));
        if (isNew) surface_.mesh.vertices.emplace_back(point);
        return entry->second;
    }

    VolumeSurface& surface_;
    std::unordered_map<std::array<float, 3>, std::uint32_t, Hash> known_;
};

} // namespace

Result<VolumeSurface> surfaceOf(const VolumeSnapshot& volume, Progress& progress) {
    return surfaceOf(volume, 0.0, progress);
}

Result<VolumeSurface> surfaceOf(const VolumeSnapshot& volume, double tolerance, Progress& progress) try {
    VolumeSurface surface;
    Welder welder(surface);
    SurfaceExtractor extractor;
    SurfaceMesh tile;
    const glm::ivec2 tiles = surfaceTiles(volume.grid());
    for (std::int32_t v = 0; v < tiles.y; ++v)
        for (std::int32_t u = 0; u < tiles.x; ++u) {
            if (progress.cancelled()) return Error{ErrorCode::cancelled, "volume", {}, {}};
            extractor.extract(volume, {u, v}, {0, tolerance}, tile);
            welder.add(tile);
            progress.report(static_cast<double>(v * tiles.x + u + 1) / (tiles.x * tiles.y));
        }
    return surface;
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, "volume", {}, {}};
}

} // namespace burin
