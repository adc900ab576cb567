// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace burin {

/// A block's place in its arena, in units of 64 bytes. 0: none.
using BlockIndex = std::uint32_t;
inline constexpr BlockIndex noBlock = 0;

/// What stands before the content of every block.
struct BlockHeader {
    std::uint64_t birth = 0;     ///< epoch of the volume in which it was made
    BlockIndex next = noBlock;   ///< in a list of free or of dead blocks
    std::uint32_t users = 0;     ///< places of the writer's present table that refer to it; the writer's own
    std::uint32_t capacity = 0;  ///< tiles: segments there is room for
    std::uint16_t sizeClass = 0; ///< the arena's
    bool wide = false;           ///< tiles: 32-bit offsets
};

/// Memory for the blocks of one volume: mapped and touched once, handed out in size classes. One thread (the writer)
/// allocates and releases; other threads give blocks back through stacks without a lock, so the writer never waits.
class BlockArena {
public:
    /// Nothing when the system has not that much memory.
    static std::unique_ptr<BlockArena> make(std::size_t bytes);
    ~BlockArena();
    BlockArena(const BlockArena&) = delete;
    BlockArena& operator=(const BlockArena&) = delete;

    /// A block of `bytes` or more, header included; its size class is set. noBlock when the memory is used up. Writer.
    BlockIndex allocate(std::size_t bytes) noexcept;
    /// Writer.
    void release(BlockIndex block) noexcept;
    /// Joins free blocks that lie side by side, so that larger ones can be had. Sorts all of them (allocates): not for
    /// the haptic loop. Writer. @throws std::bad_alloc
    void joinFreeBlocks();
    /// Any thread, one at a time.
    void giveBack(BlockIndex block) noexcept;

    BlockHeader* at(BlockIndex block) const noexcept {
        return reinterpret_cast<BlockHeader*>(memory_ + std::size_t{block} * unitBytes);
    }
    /// Bytes of a block, header included.
    std::size_t bytesOf(const BlockHeader& block) const noexcept;
    std::size_t reservedBytes() const noexcept { return std::size_t{unitCount_} * unitBytes; }
    std::size_t usedBytes() const noexcept;

    /// Behind any block so many bytes may be read as well, so that its end can be read in whole registers. What stands
    /// there means nothing, and a writer may be changing it.
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
    std::size_t handedOut_ = 0;   ///< units, by the writer's count
    std::array<BlockIndex, classCount> free_{};
    std::array<std::atomic<BlockIndex>, classCount> returned_{};
    std::atomic<std::size_t> returnedUnits_{0}; ///< all that other threads ever gave back
};

} // namespace burin
