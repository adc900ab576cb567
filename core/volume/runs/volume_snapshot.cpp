// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"
#include "core/volume/runs/volume_store.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace burin {

VolumeSnapshot::VolumeSnapshot(VolumeState* state) noexcept : state_(state) {
    state_->readers.store(1, std::memory_order_relaxed);
}

VolumeSnapshot::VolumeSnapshot(const VolumeSnapshot& other) noexcept : state_(other.state_) {
    if (state_ != nullptr) state_->readers.fetch_add(1, std::memory_order_relaxed);
}

VolumeSnapshot::VolumeSnapshot(VolumeSnapshot&& other) noexcept : state_(std::exchange(other.state_, nullptr)) {}

VolumeSnapshot& VolumeSnapshot::operator=(VolumeSnapshot other) noexcept {
    std::swap(state_, other.state_);
    return *this;
}

VolumeSnapshot::~VolumeSnapshot() {
    if (state_ != nullptr && state_->readers.fetch_sub(1, std::memory_order_acq_rel) == 1) VolumeStore::release(state_);
}

const Grid& VolumeSnapshot::grid() const noexcept {
    return state_->store->grid;
}
const PropertyList& VolumeSnapshot::properties() const noexcept {
    return state_->store->properties;
}

std::span<const Segment> VolumeSnapshot::line(LineIndex line) const noexcept {
    return state_->store->line(state_->pages, line);
}

std::span<const Segment> VolumeSnapshot::brick(LineIndex line) const noexcept {
    return state_->store->tileAt(state_->pages, line).all();
}

bool VolumeSnapshot::sameVolume(const VolumeSnapshot& other) const noexcept {
    return state_ != nullptr && other.state_ != nullptr && state_->store == other.state_->store;
}

bool VolumeSnapshot::sharesBrick(const VolumeSnapshot& other, LineIndex line) const noexcept {
    const VolumeStore& store = *state_->store;
    const std::size_t page = store.table.pageOf(line);
    const BlockIndex own = state_->pages[page], others = other.state_->pages[page];
    if (own == others) return true;
    const auto entry = static_cast<std::size_t>(TileTable::entryOf(line));
    return store.page(own)[entry] == store.page(others)[entry];
}

RunAmounts VolumeSnapshot::amounts() const {
    constexpr std::int32_t rowsPerPart = 16;
    const std::int32_t rows = grid().lineCountV();
    std::vector<RunAmounts> parts(static_cast<std::size_t>((rows + rowsPerPart - 1) / rowsPerPart));
    parallelFor(std::size_t{0}, parts.size(), [&](std::size_t part) {
        const std::int32_t first = static_cast<std::int32_t>(part) * rowsPerPart;
        for (std::int32_t v = first; v < std::min(first + rowsPerPart, rows); ++v)
            for (std::int32_t u = 0; u < grid().lineCountU(); ++u) {
                RunPosition start = 0;
                for (const Segment segment : line({u, v})) {
                    parts[part].units[segment.property()] += segment.end() - start;
                    start = segment.end();
                }
            }
    });
    RunAmounts total;
    for (const RunAmounts& part : parts)
        for (std::size_t i = 0; i < total.units.size(); ++i) total.units[i] += part.units[i];
    return total;
}

} // namespace burin
