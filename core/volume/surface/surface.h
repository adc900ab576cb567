// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace burin {

/// Scanlines along u and v that one piece of a workpiece's surface covers, at full run length.
inline constexpr std::int32_t linesPerSurfaceTile = 32;

/// A piece of a surface: tile u covers the scanlines 32 u … 32 u + 31, v alike.
struct SurfaceTile {
    std::int32_t u = 0, v = 0;
    friend constexpr bool operator==(SurfaceTile, SurfaceTile) = default;
};

/// A part of a tile: brick n covers the voxels 32 n … 32 n + 31 along the runs.
struct SurfaceBrick {
    std::int32_t u = 0, v = 0, n = 0;
    friend constexpr bool operator==(SurfaceBrick, SurfaceBrick) = default;
};

/// Triangles of a piece, mm, setup frame; counter-clockwise from outside. Without simplification some points beside the
/// tile's border are used by the next tile's triangles alone.
struct SurfaceMesh {
    std::vector<glm::vec3> points;
    std::vector<glm::vec3> normals;        ///< unit, outwards, a point each
    std::vector<PropertyIndex> properties; ///< of the material under a point
    std::vector<std::uint32_t> triangles;  ///< three corners each
    void clear();
};

inline constexpr int coarsestSurfaceLevel = 3;

/// How fine a surface is drawn.
struct SurfaceDetail {
    int level = 0;          ///< cells of 2^level voxels, 0 … 3
    double tolerance = 0.0; ///< mm that simplification may move the surface, either way; 0: every cell keeps its
                            ///< triangles
};

/// Makes the surface of everything in a workpiece but air, tile by tile, smooth from the sub-voxel run ends. Tiles of
/// one detail meet without a gap. Keeps its working storage from call to call: one object a thread.
class SurfaceExtractor {
public:
    SurfaceExtractor();
    ~SurfaceExtractor();
    SurfaceExtractor(SurfaceExtractor&&) noexcept;
    SurfaceExtractor& operator=(SurfaceExtractor&&) noexcept;

    /// @param mesh replaced
    void extract(const VolumeSnapshot& workpiece, SurfaceTile tile, const SurfaceDetail& detail, SurfaceMesh& mesh);

    /// The part of a tile's surface that starts in one brick, at full detail and with all triangles. Bricks meet
    /// without a gap, and together they are the tile. Cost: the scanlines under the brick and its own surface; nothing
    /// is allocated once the storage has grown to what a brick takes.
    /// @param mesh replaced
    void extractBrick(const VolumeSnapshot& workpiece, SurfaceBrick brick, SurfaceMesh& mesh);

private:
    class Storage;
    std::unique_ptr<Storage> storage_;
};

/// How many tiles a grid has along u and v.
glm::ivec2 surfaceTiles(const Grid& grid);

/// Tiles whose surface may differ between two snapshots, those beside a change included; of two volumes of one grid by
/// what their bricks hold. Everything when `before` is empty or of another grid.
/// @param level the coarsest that is drawn: the coarser, the farther a change reaches
std::vector<SurfaceTile> changedSurface(const VolumeSnapshot& before, const VolumeSnapshot& now,
                                        int level = coarsestSurfaceLevel);
/// Bricks whose surface at full detail may differ between two snapshots of one volume, each once, by tile: those where
/// scanlines changed, and those beside. Everything when `before` is empty or shows another volume.
/// Cost: the parts of the table that were written in between, and the scanlines that changed.
/// @param bricks replaced
void changedSurfaceBricks(const VolumeSnapshot& before, const VolumeSnapshot& now, std::vector<SurfaceBrick>& bricks);

} // namespace burin
