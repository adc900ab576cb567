// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace burin {

/// The bricks that are still to be written, in the order of arrival, and the number of them that a tick has to write so
/// that none waits longer than `longestDelay` ticks and no tick writes many more than another. Stores only the numbers
/// of bricks, not their content. Allocates only in the constructor. Only on the workpiece's writer thread.
class WriteQueue {
public:
    static constexpr std::uint32_t longestDelay = 16; ///< ticks, the longest time that a brick waits

    /// Allocates. @param bricks number of bricks: 0 … bricks - 1 may wait
    explicit WriteQueue(std::size_t bricks);

    bool empty() const noexcept { return count_ == 0; }
    bool holds(std::uint32_t brick) const noexcept { return links_[brick].waits; }
    /// Appends a brick that is not waiting yet.
    void add(std::uint32_t brick) noexcept;
    /// Removes a waiting brick, wherever it is in the queue.
    void remove(std::uint32_t brick) noexcept;
    /// Returns the brick that waits longest; empty if none waits.
    std::optional<std::uint32_t> first() const noexcept {
        return first_ == none ? std::nullopt : std::optional(first_);
    }
    /// Returns how many bricks are to be written in this tick, such that with even writing none is late.
    std::uint32_t pace() const noexcept;
    /// Ends a tick. The bricks that `pace` requested must have been removed.
    void nextTick() noexcept { ++tick_; }
    void clear() noexcept;

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    struct Link {
        std::uint32_t before = none, after = none;
        std::uint8_t due = 0; ///< tick, modulo `longestDelay`
        bool waits = false;
    };
    std::vector<Link> links_; ///< of each brick
    std::uint32_t first_ = none, last_ = none;
    std::size_t count_ = 0;
    std::array<std::uint32_t, longestDelay> dueCounts_{}; ///< number of bricks by the tick in which they are due
    std::uint32_t tick_ = 0;
};

} // namespace burin
