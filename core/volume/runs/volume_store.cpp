// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/volume_store.h"

#include <utility>

namespace burin {

void DeadList::push(BlockArena& arena, BlockIndex block) noexcept {
    arena.at(block)->next = first;
    first = block;
    if (last == noBlock) last = block;
}

void DeadList::append(BlockArena& arena, DeadList& other) noexcept {
    if (other.first == noBlock) return;
    arena.at(other.last)->next = first;
    first = other.first;
    if (last == noBlock) last = other.last;
    other = {};
}

TileTable::TileTable(const Grid& grid) noexcept
    : tilesU((grid.lineCountU() + tileSide - 1) / tileSide)
    , tilesV((grid.lineCountV() + tileSide - 1) / tileSide)
    , pagesU((tilesU + pageSide - 1) / pageSide)
    , pagesV((tilesV + pageSide - 1) / pageSide) {}

VolumeStore::VolumeStore(const Grid& itsGrid, PropertyList itsProperties, std::unique_ptr<BlockArena> itsArena)
    : grid(itsGrid), properties(std::move(itsProperties)), table(grid), arena(std::move(itsArena)) {
    for (int i = 0; i < preparedStates; ++i) {
        VolumeState* state = states_.emplace_back(std::make_unique<VolumeState>()).get();
        state->pages.resize(table.pageCount());
        state->next = std::exchange(spare_, state);
    }
}

VolumeState* VolumeStore::obtainState() {
    if (spare_ == nullptr) spare_ = returnedStates_.exchange(nullptr, std::memory_order_acquire);
    if (spare_ == nullptr) {
        spare_ = states_.emplace_back(std::make_unique<VolumeState>()).get();
        spare_->pages.resize(table.pageCount());
    }
    VolumeState* state = spare_;
    spare_ = state->next;
    state->next = nullptr;
    state->released = false;
    return state;
}

void VolumeStore::publish(VolumeState* state) noexcept {
    heldSnapshots_.fetch_add(1, std::memory_order_relaxed);
    VolumeState* newest = published_.load(std::memory_order_relaxed);
    do {
        state->next = newest;
    } while (!published_.compare_exchange_weak(newest, state, std::memory_order_release, std::memory_order_relaxed));
}

void VolumeStore::release(VolumeState* state) noexcept {
    const std::shared_ptr<VolumeStore> store = std::move(state->store); // may be the store's last owner
    const std::lock_guard lock(store->mutex_);
    store->receive();
    state->released = true;
    store->heldSnapshots_.fetch_sub(1, std::memory_order_release);
    store->reclaim();
}

/// Appends newly published states to the list of snapshots by epoch.
void VolumeStore::receive() noexcept {
    VolumeState* newest = published_.exchange(nullptr, std::memory_order_acquire);
    VolumeState* ordered = nullptr;
    while (newest != nullptr) {
        VolumeState* const earlier = newest->next;
        newest->next = std::exchange(ordered, newest);
        newest = earlier;
    }
    VolumeState** end = &oldest_;
    while (*end != nullptr) end = &(*end)->next;
    *end = ordered;
}

/// Removes released snapshots. The newest stays: blocks that died since are still on the writer's own list.
void VolumeStore::reclaim() noexcept {
    std::uint64_t epochBefore = 0;
    for (VolumeState** place = &oldest_; *place != nullptr && (*place)->next != nullptr;) {
        VolumeState* const state = *place;
        if (!state->released) {
            epochBefore = state->epoch;
            place = &state->next;
            continue;
        }
        VolumeState* const later = state->next;
        freeYoungerThan(later->dead, epochBefore);
        later->dead.append(*arena, state->dead);
        *place = later;
        state->next = returnedStates_.load(std::memory_order_relaxed);
        while (!returnedStates_.compare_exchange_weak(state->next, state, std::memory_order_release,
                                                      std::memory_order_relaxed)) {
        }
    }
}

void VolumeStore::freeYoungerThan(DeadList& list, std::uint64_t epoch) noexcept {
    DeadList kept;
    for (BlockIndex block = list.first; block != noBlock;) {
        BlockHeader* const header = arena->at(block);
        const BlockIndex next = header->next;
        if (header->birth > epoch)
            arena->giveBack(block);
        else
            kept.push(*arena, block);
        block = next;
    }
    list = kept;
}

void VolumeStore::unlistRevived(DeadList& writers) {
    const std::lock_guard lock(mutex_);
    receive();
    unlist(writers);
    for (VolumeState* state = oldest_; state != nullptr; state = state->next) unlist(state->dead);
}

void VolumeStore::unlist(DeadList& list) noexcept {
    DeadList kept;
    for (BlockIndex block = list.first; block != noBlock;) {
        const BlockHeader* const header = arena->at(block);
        const BlockIndex next = header->next;
        if (header->users == 0) kept.push(*arena, block);
        block = next;
    }
    list = kept;
}

} // namespace burin
