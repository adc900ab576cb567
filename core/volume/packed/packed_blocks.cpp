// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/packed/packed_blocks.h"

#include "core/base/parallel.h"

#include <functional>

namespace burin {

PackedBlocks packBlocks(const VolumeStore& store, std::span<const BlockIndex> blocks) {
    constexpr std::size_t tilesPerPart = 64;
    struct Part {
        std::string bytes;
        std::vector<std::size_t> lengths;
    };
    std::vector<Part> parts((blocks.size() + tilesPerPart - 1) / tilesPerPart);
    const PackedTileFrame frame = packedFrame(store.grid, store.properties);
    parallelIntervals(std::size_t{0}, parts.size(), 1, [&](std::size_t from, std::size_t to) {
        TilePacker packer(frame);
        for (std::size_t i = from; i < to; ++i) {
            Part& part = parts[i];
            const std::size_t first = i * tilesPerPart;
            for (const BlockIndex block : blocks.subspan(first, std::min(tilesPerPart, blocks.size() - first))) {
                const std::size_t before = part.bytes.size();
                packer.pack(store.tile(block).view(), part.bytes);
                part.lengths.push_back(part.bytes.size() - before);
            }
        }
    });
    PackedBlocks packed;
    packed.starts.reserve(blocks.size() + 1);
    packed.starts.push_back(0);
    for (const Part& part : parts) {
        packed.bytes += part.bytes;
        for (const std::size_t length : part.lengths) packed.starts.push_back(packed.starts.back() + length);
    }
    return packed;
}

std::uint64_t InternedTiles::add(std::string_view tile) {
    const std::size_t hash = std::hash<std::string_view>{}(tile);
    const auto [first, end] = places_.equal_range(hash);
    for (auto place = first; place != end; ++place)
        if (std::string_view(bytes_).substr(place->second.start, place->second.length) == tile)
            return place->second.start;
    const std::uint64_t start = bytes_.size();
    bytes_ += tile;
    places_.emplace(hash, Place{start, tile.size()});
    return start;
}

std::string InternedTiles::take() {
    places_.clear();
    bytes_.shrink_to_fit();
    return std::move(bytes_);
}

} // namespace burin
