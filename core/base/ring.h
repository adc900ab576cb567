// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace burin {

/// Queue of fixed capacity between one writing and one reading thread: no lock, no allocation after construction.
template <class T>
class Ring {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    /// @param capacity rounded up to a power of two. Allocates and touches all of it.
    explicit Ring(std::size_t capacity) {
        std::size_t size = 1;
        while (size < capacity) size *= 2;
        slots_.resize(size);
    }
    std::size_t capacity() const noexcept { return slots_.size(); }

    /// Writer's thread. Returns false and changes nothing if the ring is full.
    bool push(const T& value) noexcept {
        const std::size_t tail = tail_.load(std::memory_order_relaxed);
        if (tail - head_.load(std::memory_order_acquire) == slots_.size()) return false;
        slots_[tail & (slots_.size() - 1)] = value;
        tail_.store(tail + 1, std::memory_order_release);
        return true;
    }
    /// Reader's thread: moves up to `target.size()` of the oldest values to `target` and returns their number.
    std::size_t pop(std::span<T> target) noexcept {
        const std::size_t head = head_.load(std::memory_order_relaxed);
        const std::size_t waiting = tail_.load(std::memory_order_acquire) - head;
        const std::size_t count = waiting < target.size() ? waiting : target.size();
        for (std::size_t i = 0; i < count; ++i) target[i] = slots_[(head + i) & (slots_.size() - 1)];
        head_.store(head + count, std::memory_order_release);
        return count;
    }
    /// Thread-safe; exact only for the writer and the reader.
    std::size_t size() const noexcept {
        const std::size_t head = head_.load(std::memory_order_acquire);
        return tail_.load(std::memory_order_acquire) - head;
    }

private:
    std::vector<T> slots_;
    alignas(64) std::atomic<std::size_t> head_{0};
    alignas(64) std::atomic<std::size_t> tail_{0};
};

} // namespace burin
