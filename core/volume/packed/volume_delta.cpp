// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/packed/volume_delta.h"

#include "core/volume/packed/packed_blocks.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace burin {

struct VolumeDeltaPacker::Work {
    struct Difference {
        LineIndex corner;
        BlockIndex before = noBlock, after = noBlock;
    };

    VolumeSnapshot before, after;
    std::vector<Difference> differences;
    std::size_t done = 0;
    InternedTiles tiles;
    VolumeDelta delta;

    void findDifferences();
};

/// A block that both states share can't have changed.
void VolumeDeltaPacker::Work::findDifferences() {
    const VolumeState &first = VolumeAccess::state(before), &second = VolumeAccess::state(after);
    const VolumeStore& store = *first.store;
    const TileTable& table = store.table;
    for (std::size_t page = 0; page < first.pages.size(); ++page) {
        if (first.pages[page] == second.pages[page]) continue;
        const auto pagesU = static_cast<std::size_t>(table.pagesU);
        const auto tileU = static_cast<std::int32_t>(page % pagesU) * TileTable::pageSide;
        const auto tileV = static_cast<std::int32_t>(page / pagesU) * TileTable::pageSide;
        const auto blocks = store.page(first.pages[page]), others = store.page(second.pages[page]);
        for (std::int32_t entry = 0; entry < TileTable::tilesPerPage; ++entry) {
            const auto place = static_cast<std::size_t>(entry);
            if (blocks[place] == others[place]) continue;
            const std::int32_t u = tileU + entry % TileTable::pageSide, v = tileV + entry / TileTable::pageSide;
            differences.push_back({{u * tileSide, v * tileSide}, blocks[place], others[place]});
        }
    }
}

VolumeDeltaPacker::VolumeDeltaPacker(VolumeSnapshot before, VolumeSnapshot after) : work_(std::make_unique<Work>()) {
    assert(before.sameVolume(after));
    work_->before = std::move(before);
    work_->after = std::move(after);
    work_->findDifferences();
}
VolumeDeltaPacker::~VolumeDeltaPacker() = default;
VolumeDeltaPacker::VolumeDeltaPacker(VolumeDeltaPacker&&) noexcept = default;
VolumeDeltaPacker& VolumeDeltaPacker::operator=(VolumeDeltaPacker&&) noexcept = default;

bool VolumeDeltaPacker::advance(std::size_t bricks) {
    Work& work = *work_;
    const std::size_t count = std::min(bricks, work.differences.size() - work.done);
    const std::span<const Work::Difference> next = std::span(work.differences).subspan(work.done, count);
    std::vector<BlockIndex> blocks;
    for (const Work::Difference& difference : next) {
        blocks.push_back(difference.before);
        blocks.push_back(difference.after);
    }
    const PackedBlocks packed = packBlocks(*VolumeAccess::state(work.before).store, blocks);
    for (std::size_t i = 0; i < count; ++i) {
        const std::string_view before = packed.tile(2 * i), after = packed.tile(2 * i + 1);
        if (before != after)
            work.delta.bricks_.push_back({next[i].corner, work.tiles.add(before), work.tiles.add(after)});
        ++work.done;
    }
    return work.done == work.differences.size();
}

VolumeDelta VolumeDeltaPacker::take() {
    assert(work_->done == work_->differences.size());
    work_->delta.bytes_ = work_->tiles.take();
    work_->delta.bricks_.shrink_to_fit();
    return std::move(work_->delta);
}

VolumeDelta deltaBetween(const VolumeSnapshot& before, const VolumeSnapshot& after) {
    VolumeDeltaPacker packer(before, after);
    packer.advance(std::numeric_limits<std::size_t>::max());
    return packer.take();
}

bool VolumeDelta::put(RunVolume& volume, std::uint64_t Brick::*moment) const {
    auto& writer = VolumeAccess::writer(volume);
    const PackedTileFrame frame = packedFrame(volume.grid(), volume.properties());
    const VolumeSnapshot unchanged = volume.snapshot(); // to restore on failure
    BrickLines lines(frame.lineEnd);
    for (const Brick& brick : bricks_) {
        const bool sound = unpackTile(std::string_view(bytes_).substr(brick.*moment), frame, lines);
        assert(sound);
        if (sound && writer.setBrick(brick.corner, lines)) continue;
        volume.restore(unchanged);
        return false;
    }
    return true;
}

Result<void> VolumeDelta::apply(RunVolume& volume, std::uint64_t Brick::*moment) const {
    if (put(volume, moment)) return {};
    VolumeAccess::writer(volume).joinFreeMemory();
    if (put(volume, moment)) return {};
    return Error{ErrorCode::volumeOutOfMemory, std::to_string(volume.reservedBytes()), {}, {}};
}

} // namespace burin
