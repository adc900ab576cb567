// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/block_arena.h"

#include "core/base/available_memory.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <limits>
#include <new>
#include <sys/mman.h>
#include <vector>

namespace burin {

namespace {

/// Sizes of the classes in units: each size up to 32, then in steps of an eighth, so that at most an eighth is wasted.
template <std::size_t count>
constexpr std::array<std::uint32_t, count> makeClassSizes() {
    std::array<std::uint32_t, count> sizes{};
    std::uint32_t size = 0;
    for (auto& entry : sizes) {
        size += size < 32 ? 1 : size / 8;
        entry = size;
    }
    return sizes;
}

constexpr auto classSizes = makeClassSizes<176>();
static_assert(classSizes.back() > (1U << 28), "a class for every tile that 16.8-bit run ends allow");

constexpr std::size_t classAmong(std::size_t units) {
    return static_cast<std::size_t>(std::lower_bound(classSizes.begin(), classSizes.end(), units) - classSizes.begin());
}

/// Precomputed classes of the smallest sizes: a tick allocates several blocks, and a search would be mispredicted at
/// every step.
constexpr std::size_t sizesAtHand = 1024; // units: 64 KiB
constexpr auto classesAtHand = [] {
    static_assert(classSizes.size() <= 256);
    std::array<std::uint8_t, sizesAtHand> classes{};
    for (std::size_t units = 0; units < sizesAtHand; ++units)
        classes[units] = static_cast<std::uint8_t>(classAmong(units));
    return classes;
}();

} // namespace

std::unique_ptr<BlockArena> BlockArena::make(std::size_t bytes) {
    constexpr std::size_t page = std::size_t{2} << 20;
    const std::size_t mapped = (std::max(bytes, unitBytes * 2) + overread + page - 1) / page * page;
    if (bytes > std::numeric_limits<BlockIndex>::max() * unitBytes) return nullptr;
    // The system overcommits memory; touching it would then trigger its out-of-memory killer.
    if (mapped > availableMemory()) return nullptr;
    void* memory = ::mmap(nullptr, mapped, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return nullptr;
    auto arena = std::unique_ptr<BlockArena>(new (std::nothrow) BlockArena(static_cast<std::byte*>(memory), mapped));
    if (!arena) {
        ::munmap(memory, mapped);
        return nullptr;
    }
    arena->unitCount_ = static_cast<std::uint32_t>(std::max(bytes, unitBytes * 2) / unitBytes);
    // The first access to a page costs a fault, which the haptic loop must not pay for.
    (void)::madvise(memory, mapped, MADV_HUGEPAGE);
    std::byte* const first = arena->memory_;
    parallelIntervals(std::size_t{0}, (arena->reservedBytes() + page - 1) / page, 1,
                      [first, mapped](std::size_t from, std::size_t to) {
                          for (std::size_t offset = from * page; offset < std::min(to * page, mapped); offset += 4096)
                              first[offset] = std::byte{0};
                      });
    return arena;
}

BlockArena::BlockArena(std::byte* memory, std::size_t mappedBytes) noexcept
    : memory_(memory), mappedBytes_(mappedBytes), unitCount_(0) {
    static_assert(classSizes.size() == classCount);
}

BlockArena::~BlockArena() {
    ::munmap(memory_, mappedBytes_);
}

std::size_t BlockArena::classFor(std::size_t units) noexcept {
    return units < sizesAtHand ? classesAtHand[units] : classAmong(units);
}

std::size_t BlockArena::bytesOf(const BlockHeader& block) const noexcept {
    return classSizes[block.sizeClass] * unitBytes;
}

std::size_t BlockArena::usedBytes() const noexcept {
    return (handedOut_ - returnedUnits_.load(std::memory_order_relaxed)) * unitBytes;
}

BlockIndex BlockArena::take(std::size_t sizeClass) noexcept {
    BlockIndex& first = free_[sizeClass];
    if (first == noBlock && returned_[sizeClass].load(std::memory_order_relaxed) != noBlock)
        first = returned_[sizeClass].exchange(noBlock, std::memory_order_acquire);
    const BlockIndex block = first;
    if (block == noBlock) return noBlock;
    first = at(block)->next;
    __builtin_prefetch(at(first)); // the next one to be taken, no longer in the cache; for none, memory that is not
                                   // read
    return block;
}

BlockIndex BlockArena::allocate(std::size_t bytes) noexcept {
    const std::size_t wanted = classFor((bytes + unitBytes - 1) / unitBytes);
    if (wanted >= classCount) return noBlock;
    BlockIndex block = take(wanted);
    if (block == noBlock && classSizes[wanted] <= unitCount_ - untouched_) {
        block = untouched_;
        untouched_ += classSizes[wanted];
    }
    if (block == noBlock) block = split(wanted);
    if (block == noBlock) return noBlock;
    *at(block) = BlockHeader{};
    at(block)->sizeClass = static_cast<std::uint16_t>(wanted);
    handedOut_ += classSizes[wanted];
    return block;
}

BlockIndex BlockArena::split(std::size_t sizeClass) noexcept {
    for (std::size_t larger = sizeClass + 1; larger < classCount; ++larger) {
        const BlockIndex block = take(larger);
        if (block == noBlock) continue;
        shelve(block + classSizes[sizeClass], classSizes[larger] - classSizes[sizeClass]);
        return block;
    }
    return noBlock;
}

/// Cuts an interval of free units into blocks.
void BlockArena::shelve(BlockIndex first, std::size_t units) noexcept {
    while (units > 0) {
        std::size_t sizeClass = classFor(units);
        if (sizeClass == classCount || classSizes[sizeClass] > units) --sizeClass;
        BlockHeader* header = at(first);
        *header = BlockHeader{};
        header->sizeClass = static_cast<std::uint16_t>(sizeClass);
        header->next = free_[sizeClass];
        free_[sizeClass] = first;
        first += classSizes[sizeClass];
        units -= classSizes[sizeClass];
    }
}

void BlockArena::joinFreeBlocks() {
    struct Interval {
        BlockIndex first;
        std::uint32_t units;
    };
    std::vector<Interval> intervals;
    for (std::size_t sizeClass = 0; sizeClass < classCount; ++sizeClass)
        for (BlockIndex block = take(sizeClass); block != noBlock; block = take(sizeClass))
            intervals.push_back({block, classSizes[sizeClass]});
    std::ranges::sort(intervals, {}, &Interval::first);
    for (std::size_t i = 0; i < intervals.size();) {
        Interval joined = intervals[i++];
        while (i < intervals.size() && intervals[i].first == joined.first + joined.units)
            joined.units += intervals[i++].units;
        if (joined.first + joined.units == untouched_)
            untouched_ = joined.first;
        else
            shelve(joined.first, joined.units);
    }
}

void BlockArena::release(BlockIndex block) noexcept {
    BlockHeader* header = at(block);
    header->next = free_[header->sizeClass];
    free_[header->sizeClass] = block;
    handedOut_ -= classSizes[header->sizeClass];
}

void BlockArena::giveBack(BlockIndex block) noexcept {
    BlockHeader* header = at(block);
    const std::size_t sizeClass = header->sizeClass;
    returnedUnits_.fetch_add(classSizes[sizeClass], std::memory_order_relaxed);
    BlockIndex first = returned_[sizeClass].load(std::memory_order_relaxed);
    // The writer only ever takes the whole stack, so a first block that is back again can't be mistaken (no ABA).
    do {
        header->next = first;
    } while (!returned_[sizeClass].compare_exchange_weak(first, block, std::memory_order_release,
                                                         std::memory_order_relaxed));
}

} // namespace burin
