// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace burin {

/// Position of a block in its arena, in units of 64 bytes. 0 means no block.
using BlockIndex = std::uint32_t;
inline constexpr BlockIndex noBlock = 0;

/// Header at the start of every block.
struct BlockHeader {
    std::uint64_t birth = 0;     ///< epoch of the volume in which it was made
    BlockIndex next = noBlock;   ///< link in a list of free or of dead blocks
    std::uint32_t users = 0;     ///< references from the writer's current table; used by the writer only
    std::uint32_t capacity = 0;  ///< tiles: number of segments that fit
    std::uint16_t sizeClass = 0; ///< size class of the arena
    bool wide = false;           ///< tiles: 32-bit offsets
};

/// Memory for the blocks of one volume: mapped and touched once, handed out in size classes. One thread (the writer)
/// allocates and releases; other threads give blocks back through stacks without a lock, so the writer never waits.
class BlockArena {
public:
    /// Returns null if the system does not have that much memory.
    static std::unique_ptr<BlockArena> make(std::size_t bytes);
    ~BlockArena();
    BlockArena(const BlockArena&) = delete;
    BlockArena& operator=(const BlockArena&) = delete;

    /// Returns a block of at least `bytes`, header included, with its size class set, or noBlock if the memory is used
    /// up. Called by the writer.
    BlockIndex allocate(std::size_t bytes) noexcept;
    /// Called by the writer.
    void release(BlockIndex block) noexcept;
    /// Joins adjacent free blocks so that larger ones can be allocated. Sorts all free blocks (allocates): not for the
    /// haptic loop. Called by the writer. @throws std::bad_alloc
    void joinFreeBlocks();
    /// Any thread, one at a time.
    void giveBack(BlockIndex block) noexcept;

    BlockHeader* at(BlockIndex block) const noexcept {
        return reinterpret_cast<BlockHeader*>(memory_ + std::size_t{block} * unitBytes);
    }
    /// Size of a block in bytes, header included.
    std::size_t bytesOf(const BlockHeader& block) const noexcept;
    std::size_t reservedBytes() const noexcept { return std::size_t{unitCount_} * unitBytes; }
    std::size_t usedBytes() const noexcept;

    /// This many bytes behind any block may be read, so that the end of a block can be read in whole registers. Their
    /// content is undefined, and a writer may be changing it.
    static constexpr std::size_t overread = 64;

private:
    static constexpr std::size_t unitBytes = 64;
    static constexpr std::size_t classCount = 176;

    BlockArena(std::byte* memory, std::size_t mappedBytes) noexcept;
    static std::size_t classFor(std::size_t units) noexcept;
    BlockIndex take(std::size_t sizeClass) noexcept;
    BlockIndex split(std::size_t sizeClass) noexcept;
    void shelve(BlockIndex first, std::size_t units) noexcept;

    std::byte* memory_;
    std::size_t mappedBytes_;
    std::uint32_t unitCount_;
    std::uint32_t untouched_ = 1; ///< first unit that was never handed out; unit 0 stands for "none"
    std::size_t handedOut_ = 0;   ///< units, as counted by the writer
    std::array<BlockIndex, classCount> free_{};
    std::array<std::atomic<BlockIndex>, classCount> returned_{};
    std::atomic<std::size_t> returnedUnits_{0}; ///< total that other threads have given back
};

} // namespace burin
