// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace burin {

/// Number of scanlines along u and v in one tile of a workpiece's surface, which covers the full run length.
inline constexpr std::int32_t linesPerSurfaceTile = 32;

/// A tile of a surface: tile u covers the scanlines 32 u … 32 u + 31, and v likewise.
struct SurfaceTile {
    std::int32_t u = 0, v = 0;
    friend constexpr bool operator==(SurfaceTile, SurfaceTile) = default;
};

/// A part of a tile: brick n covers the voxels 32 n … 32 n + 31 along the runs.
struct SurfaceBrick {
    std::int32_t u = 0, v = 0, n = 0;
    friend constexpr bool operator==(SurfaceBrick, SurfaceBrick) = default;
};

/// Triangles of a tile, mm, setup frame; counter-clockwise from outside. Without simplification some points beyond the
/// tile's border are used only by the triangles of the next tile.
struct SurfaceMesh {
    std::vector<glm::vec3> points;
    std::vector<glm::vec3> normals;        ///< unit length, outwards, one per point
    std::vector<PropertyIndex> properties; ///< of the material under a point
    std::vector<std::uint32_t> triangles;  ///< three corners per triangle
    void clear();
};

inline constexpr int coarsestSurfaceLevel = 3;

/// Resolution of a drawn surface.
struct SurfaceDetail {
    int level = 0;          ///< cells of 2^level voxels, 0 … 3
    double tolerance = 0.0; ///< mm by which simplification may move the surface in either direction; 0: every cell
                            ///< keeps its triangles
};

/// Makes the surface of everything in a workpiece but air, tile by tile, smooth from the sub-voxel run ends. Tiles of
/// the same detail meet without a gap. Keeps its working storage from call to call: use one object per thread.
class SurfaceExtractor {
public:
    SurfaceExtractor();
    ~SurfaceExtractor();
    SurfaceExtractor(SurfaceExtractor&&) noexcept;
    SurfaceExtractor& operator=(SurfaceExtractor&&) noexcept;

    /// @param mesh replaced
    void extract(const VolumeSnapshot& workpiece, SurfaceTile tile, const SurfaceDetail& detail, SurfaceMesh& mesh);

    /// The part of a tile's surface that starts in one brick, at full detail and with all triangles. Bricks meet
    /// without a gap, and together they form the tile. Cost: grows with the scanlines of the brick and its own surface;
    /// nothing is allocated once the storage has grown to the size that a brick needs.
    /// @param mesh replaced
    void extractBrick(const VolumeSnapshot& workpiece, SurfaceBrick brick, SurfaceMesh& mesh);

private:
    class Storage;
    std::unique_ptr<Storage> storage_;
};

/// Number of tiles of a grid along u and v.
glm::ivec2 surfaceTiles(const Grid& grid);

/// Tiles whose surface may differ between two snapshots, including the neighbours of a change; snapshots of two volumes
/// on the same grid are compared by the content of their bricks. All tiles if `before` is empty or on another grid.
/// @param level  the coarsest level that is drawn: the coarser, the farther the effect of a change
std::vector<SurfaceTile> changedSurface(const VolumeSnapshot& before, const VolumeSnapshot& now,
                                        int level = coarsestSurfaceLevel);
/// Bricks whose surface at full detail may differ between two snapshots of one volume, each once, by tile: those where
/// scanlines changed, and their neighbours. All bricks if `before` is empty or shows another volume.
/// Cost: grows with the parts of the table that were written in between, and with the scanlines that changed.
/// @param bricks replaced
void changedSurfaceBricks(const VolumeSnapshot& before, const VolumeSnapshot& now, std::vector<SurfaceBrick>& bricks);

} // namespace burin
