// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/stock_shape.h"
#include "core/volume/surface/place_hash.h"
#include "core/volume/surface/surface.h"

#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <unordered_map>

namespace burin {

/// The box around all material of a workpiece. Sides from which nothing was milled are those of the stock, at voxel
/// resolution: across the runs, they are voxel faces. Null if there is no material.
std::shared_ptr<const StockShape> stockOf(const VolumeSnapshot& workpiece);

/// Restores the sharp edges of the stock on a workpiece's surface, which a surface made of voxels bevels. Untouched
/// regions are found by comparison with the surface of the untouched stock in the same grid: points that are bitwise
/// equal are moved onto the shape of the stock, all others are kept, so that no cut is hidden, however shallow.
/// Neighbouring tiles move their common points identically. One object per thread.
class StockSharpening {
public:
    StockSharpening() = default;
    /// @param stock null: not known
    StockSharpening(std::shared_ptr<const StockShape> stock, const Grid& grid);

    /// The faces of the stock; null if there are none.
    const KnownFaces* faces() const noexcept { return stock_.get(); }
    /// @param mesh all triangles of a tile at a level, not simplified
    void sharpen(SurfaceTile tile, int level, SurfaceMesh& mesh);

private:
    using Moves = std::unordered_map<glm::vec3, glm::vec3, PlaceHash>; ///< targets of points of the untouched stock
    const Moves& movesOf(SurfaceTile tile, int level);

    std::shared_ptr<const StockShape> stock_;
    std::optional<RunVolume> volume_; ///< the volume of `untouched_`
    VolumeSnapshot untouched_;
    SurfaceExtractor extractor_;
    SurfaceMesh mesh_;
    std::map<std::tuple<int, int, int>, Moves> moves_; ///< by level and tile, created on demand
};

} // namespace burin
