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

/// The box around all material of a workpiece. Where nothing was milled off its sides, they are the stock's own, as far
/// as voxels know them: across the runs, voxel faces. Null: there is no material.
std::shared_ptr<const StockShape> stockOf(const VolumeSnapshot& workpiece);

/// Gives a workpiece's surface back the sharp edges of the stock, which a surface of voxels bevels. What was not
/// touched is found by comparison with the surface of the untouched stock in the same grid: points that are equal bit
/// for bit go where the stock's shape lies, all others stay, so that no cut is hidden, however shallow. Neighbouring
/// tiles move their common points alike. One object a thread.
class StockSharpening {
public:
    StockSharpening() = default;
    /// @param stock null: nothing is known
    StockSharpening(std::shared_ptr<const StockShape> stock, const Grid& grid);

    /// Null: none.
    const KnownFaces* faces() const noexcept { return stock_.get(); }
    /// @param mesh all triangles of a tile at a level, not simplified
    void sharpen(SurfaceTile tile, int level, SurfaceMesh& mesh);

private:
    using Moves = std::unordered_map<glm::vec3, glm::vec3, PlaceHash>; ///< of points of the untouched stock
    const Moves& movesOf(SurfaceTile tile, int level);

    std::shared_ptr<const StockShape> stock_;
    std::optional<RunVolume> volume_; ///< behind `untouched_`
    VolumeSnapshot untouched_;
    SurfaceExtractor extractor_;
    SurfaceMesh mesh_;
    std::map<std::tuple<int, int, int>, Moves> moves_; ///< by level and tile, made when asked for
};

} // namespace burin
