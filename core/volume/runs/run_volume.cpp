// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/run_volume.h"

#include "core/volume/runs/run_volume_impl.h"
#include "core/volume/runs/voxel_runs.h"

#include <algorithm>
#include <new>
#include <utility>

namespace burin {

namespace {

std::size_t tileCount(const Grid& grid) noexcept {
    const TileTable table(grid);
    return static_cast<std::size_t>(table.tilesU) * static_cast<std::size_t>(table.tilesV);
}

Error outOfMemory(std::size_t bytes) {
    return {ErrorCode::outOfMemory, "volume", {}, std::to_string(bytes) + " bytes"};
}

} // namespace

std::size_t RunVolume::defaultReserve(const Grid& grid) noexcept {
    constexpr std::size_t bytesPerTile = 48 * linesPerTile, bytesPerVoxel = 16, extraLimit = std::size_t{32} << 20;
    const std::size_t lines = static_cast<std::size_t>(grid.lineCountU()) * static_cast<std::size_t>(grid.lineCountV());
    const std::size_t extra =
        std::min(extraLimit, lines * static_cast<std::size_t>(grid.voxelsPerLine()) * bytesPerVoxel);
    return tileCount(grid) * bytesPerTile + 4 * TileTable(grid).pageCount() * TileTable::pageBytes() + extra;
}

Result<RunVolume> RunVolume::make(const Grid& grid, PropertyList properties, std::size_t reservedBytes) {
    // The first table and the tile of air are not part of the memory for edits.
    constexpr std::size_t sizeClassLoss = 64;
    const std::size_t first = TileTable(grid).pageCount() * (TileTable::pageBytes() + sizeClassLoss) +
                              Tile::bytesFor(linesPerTile) + 2 * sizeClassLoss;
    const std::size_t bytes = first + (reservedBytes == 0 ? defaultReserve(grid) : reservedBytes);
    try {
        std::unique_ptr<BlockArena> arena = BlockArena::make(bytes);
        if (!arena) return outOfMemory(bytes);
        auto impl =
            std::make_unique<Impl>(std::make_shared<VolumeStore>(grid, std::move(properties), std::move(arena)));
        if (!impl->fillWithAir()) return outOfMemory(bytes);
        return RunVolume(std::move(impl));
    } catch (const std::bad_alloc&) {
        return outOfMemory(bytes);
    }
}

RunVolume::RunVolume(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
RunVolume::~RunVolume() = default;
RunVolume::RunVolume(RunVolume&&) noexcept = default;
RunVolume& RunVolume::operator=(RunVolume&&) noexcept = default;

const Grid& RunVolume::grid() const noexcept {
    return impl_->store().grid;
}
const PropertyList& RunVolume::properties() const noexcept {
    return impl_->store().properties;
}
std::span<const Segment> RunVolume::line(LineIndex line) const noexcept {
    return impl_->line(line);
}
std::span<const Segment> RunVolume::brick(LineIndex line) const noexcept {
    return impl_->brick(line);
}
void RunVolume::fetch(LineIndex line) const noexcept {
    impl_->fetch(line);
}
const RunAmounts& RunVolume::amounts() const noexcept {
    return impl_->amounts();
}
std::size_t RunVolume::reservedBytes() const noexcept {
    return impl_->store().arena->reservedBytes();
}
std::size_t RunVolume::usedBytes() const noexcept {
    return impl_->store().arena->usedBytes();
}

Removal RunVolume::removeSpan(LineIndex line, RunPosition from, RunPosition to, RunAmounts& removed) noexcept {
    return impl_->removeSpan(line, from, to, removed);
}

bool RunVolume::setAside(LineIndex line, BrickRoom& room) noexcept {
    room.block_ = impl_->setAside(line);
    return !room.empty();
}

void RunVolume::giveBack(BrickRoom& room) noexcept {
    if (!room.empty()) impl_->giveBack(std::exchange(room.block_, noBlock));
}

bool RunVolume::clear(LineIndex line, const BrickSpans& spans, BrickRoom& room) noexcept {
    return impl_->clear(line, spans, room.block_);
}

bool RunVolume::hasPagesToSpare() const noexcept {
    return impl_->hasPagesToSpare();
}

bool RunVolume::fillSpan(LineIndex line, RunPosition from, RunPosition to, PropertyIndex property) noexcept {
    return impl_->fillSpan(line, from, to, property);
}

bool RunVolume::fillBlock(LineIndex low, LineIndex high, RunPosition from, RunPosition to,
                          PropertyIndex property) noexcept {
    return impl_->fillBlock(low, high, from, to, property);
}

bool RunVolume::setLine(LineIndex line, std::span<const Segment> segments) noexcept {
    return impl_->setLine(line, segments);
}

bool RunVolume::rewriteBricks(const std::function<void(std::int32_t row, BrickSink& sink)>& describe) {
    return impl_->rewriteBricks(describe);
}

bool RunVolume::belongs(VoxelIndex voxel) const noexcept {
    return grid().contains(voxel) &&
           propertyAt(line(grid().lineOf(voxel)), centreOf(grid().alongOf(voxel))) != airProperty;
}

std::optional<Run> RunVolume::locate(VoxelIndex voxel) const noexcept {
    if (!grid().contains(voxel)) return std::nullopt;
    const std::int32_t along = grid().alongOf(voxel);
    std::optional<Run> found;
    forEachVoxelRun(line(grid().lineOf(voxel)), [&](const Run& run) {
        if (run.property != airProperty && run.first <= along && along <= run.last) found = run;
    });
    return found;
}

VoxelEdit RunVolume::insert(VoxelIndex voxel, PropertyIndex property) noexcept {
    if (property == airProperty || !grid().contains(voxel) || belongs(voxel)) return VoxelEdit::nothing;
    return fillVoxel(voxel, property);
}

VoxelEdit RunVolume::remove(VoxelIndex voxel) noexcept {
    return belongs(voxel) ? fillVoxel(voxel, airProperty) : VoxelEdit::nothing;
}

VoxelEdit RunVolume::fillVoxel(VoxelIndex voxel, PropertyIndex property) noexcept {
    const auto from = static_cast<RunPosition>(grid().alongOf(voxel)) * unitsPerVoxel;
    const bool filled = impl_->fillSpan(grid().lineOf(voxel), from, from + unitsPerVoxel, property);
    return filled ? VoxelEdit::done : VoxelEdit::outOfMemory;
}

std::vector<Run> RunVolume::runs(LineIndex index) const {
    std::vector<Run> all;
    forEachVoxelRun(line(index), [&](const Run& run) {
        if (run.property != airProperty) all.push_back(run);
    });
    return all;
}

VolumeSnapshot RunVolume::snapshot() {
    return VolumeSnapshot(impl_->snapshot());
}

void RunVolume::restore(const VolumeSnapshot& snapshot) {
    if (!snapshot.empty() && snapshot.state_->store.get() == &impl_->store()) impl_->restore(*snapshot.state_);
}

} // namespace burin
