// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <utility>

namespace burin {

/// Queue that passes ownership of values from one writing thread to one reading thread without overwriting any: what
/// the writer moved in, only the reader moves out and frees. Lock-free; neither side blocks.
template <class T, std::size_t places>
class Handover {
public:
    /// Writer's thread.
    bool full() const noexcept { return put_ - taken_.load(std::memory_order_acquire) == places; }
    /// Writer's thread; there must be room.
    void put(T&& value) noexcept {
        slots_[put_ % places] = std::move(value);
        ready_.store(++put_, std::memory_order_release);
    }
    /// Reader's thread. False if it is empty.
    bool take(T& value) noexcept {
        const std::size_t next = taken_.load(std::memory_order_relaxed);
        if (next == ready_.load(std::memory_order_acquire)) return false;
        value = std::exchange(slots_[next % places], T{});
        taken_.store(next + 1, std::memory_order_release);
        return true;
    }

private:
    std::array<T, places> slots_{};
    std::size_t put_ = 0; ///< writer's
    std::atomic<std::size_t> ready_{0}, taken_{0};
};

} // namespace burin
