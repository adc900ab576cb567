// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/packed/packed_tile.h"
#include "core/volume/runs/volume_access.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace burin {

inline PackedTileFrame packedFrame(const Grid& grid, const PropertyList& properties) noexcept {
    return {grid.lineEnd(), static_cast<std::uint32_t>(properties.size())};
}

/// Packed tiles, one after the other.
struct PackedBlocks {
    std::string bytes;
    std::vector<std::size_t> starts; ///< start of each tile, and the end of the last

    std::string_view tile(std::size_t place) const noexcept {
        return std::string_view(bytes).substr(starts[place], starts[place + 1] - starts[place]);
    }
};

/// Packs the tiles in the given blocks, in their order; parallel. A snapshot that shows the blocks must be held.
/// @throws std::bad_alloc
PackedBlocks packBlocks(const VolumeStore& store, std::span<const BlockIndex> blocks);

/// Packed tiles, each stored only once however often it is added.
class InternedTiles {
public:
    /// Returns where the tile begins in `bytes`.
    std::uint64_t add(std::string_view tile);
    /// Ends the adding and returns the bytes, without unused capacity.
    std::string take();

private:
    struct Place {
        std::uint64_t start = 0, length = 0;
    };
    std::string bytes_;
    std::unordered_multimap<std::size_t, Place> places_; ///< by hash of the bytes
};

} // namespace burin
