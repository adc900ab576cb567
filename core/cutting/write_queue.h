// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace burin {

/// Which bricks are still to be written, in the order in which they came, and how many of them a tick has to write so
/// that none waits longer than `longestDelay` ticks and no tick writes many more than another. Knows numbers of bricks
/// and nothing of what is in them. No allocation but in the constructor. Thread: the workpiece's writer.
class WriteQueue {
public:
    static constexpr std::uint32_t longestDelay = 16; ///< ticks that a brick waits at most

    /// Allocates. @param bricks that there are: 0 … bricks - 1 may wait
    explicit WriteQueue(std::size_t bricks);

    bool empty() const noexcept { return count_ == 0; }
    bool holds(std::uint32_t brick) const noexcept { return links_[brick].waits; }
    /// Puts a brick that does not wait yet behind all others.
    void add(std::uint32_t brick) noexcept;
    /// Takes out a brick that waits, wherever it stands.
    void remove(std::uint32_t brick) noexcept;
    /// The one that waits the longest; none: nothing does.
    std::optional<std::uint32_t> first() const noexcept {
        return first_ == none ? std::nullopt : std::optional(first_);
    }
    /// How many bricks are to be written in this tick: so many that, written as evenly, none is ever late.
    std::uint32_t pace() const noexcept;
    /// Ends a tick. Those that `pace` asked for have been removed.
    void nextTick() noexcept { ++tick_; }
    void clear() noexcept;

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    struct Link {
        std::uint32_t before = none, after = none;
        std::uint8_t due = 0; ///< tick, of `longestDelay`
        bool waits = false;
    };
    std::vector<Link> links_; ///< of each brick
    std::uint32_t first_ = none, last_ = none;
    std::size_t count_ = 0;
    std::array<std::uint32_t, longestDelay> dueCounts_{}; ///< bricks by the tick that they are due in
    std::uint32_t tick_ = 0;
};

} // namespace burin
