// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume_impl.h"

namespace burin {

/// Access to the blocks behind volumes and snapshots, for this library only: for code that packs, counts or compares
/// whole tiles.
class VolumeAccess {
public:
    static const VolumeState& state(const VolumeSnapshot& snapshot) noexcept { return *snapshot.state_; }
    static RunVolume::Impl& writer(RunVolume& volume) noexcept { return *volume.impl_; }

    /// The block of the tile at this position of the table.
    static BlockIndex tileAt(const VolumeState& state, std::int32_t tileU, std::int32_t tileV) noexcept {
        const LineIndex corner{tileU * tileSide, tileV * tileSide};
        const VolumeStore& store = *state.store;
        return store.page(
            state.pages[store.table.pageOf(corner)])[static_cast<std::size_t>(TileTable::entryOf(corner))];
    }
};

} // namespace burin
