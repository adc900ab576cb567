// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <type_traits>

namespace burin {

/// Passes the newest value from one writing thread to one reading thread. Never blocks, never allocates; a value that
/// is replaced by a newer one before it was read is dropped.
template <class T>
class Mailbox {
    static_assert(std::is_trivially_copyable_v<T>);

public:
    void post(const T& value) noexcept { // writer's thread
        slots_[back_] = value;
        back_ = middle_.exchange(back_ | fresh, std::memory_order_acq_rel) & slotMask;
    }
    bool take(T& value) noexcept { // reader's thread; false if there is nothing new
        if ((middle_.load(std::memory_order_relaxed) & fresh) == 0) return false;
        front_ = middle_.exchange(front_, std::memory_order_acq_rel) & slotMask;
        value = slots_[front_];
        return true;
    }

private:
    static constexpr unsigned fresh = 4, slotMask = 3;
    std::array<T, 3> slots_{};
    std::atomic<unsigned> middle_{1};
    unsigned back_ = 0, front_ = 2;
};

} // namespace burin
