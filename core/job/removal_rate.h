// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace burin {

/// The removal rate over the last 0.1 s of the session's time; over a shorter time if ticks are shorter than 0.1 ms.
class RemovalRate {
public:
    /// @param units removed in one tick. @param period s
    void add(std::uint64_t units, double period) noexcept {
        while (count_ == entries_.size() || (count_ > 0 && seconds_ + period > window)) drop();
        entries_[(first_ + count_++) % entries_.size()] = {units, period};
        units_ += units;
        seconds_ += period;
    }
    double unitsPerSecond() const noexcept { return seconds_ > 0.0 ? static_cast<double>(units_) / seconds_ : 0.0; }

private:
    static constexpr double window = 0.1 + 1e-9; ///< s
    struct Entry {
        std::uint64_t units = 0;
        double period = 0.0;
    };
    void drop() noexcept {
        units_ -= entries_[first_].units;
        first_ = (first_ + 1) % entries_.size();
        seconds_ = --count_ == 0 ? 0.0 : seconds_ - entries_[(first_ + entries_.size() - 1) % entries_.size()].period;
    }
    std::array<Entry, 1024> entries_{};
    std::size_t first_ = 0, count_ = 0;
    std::uint64_t units_ = 0;
    double seconds_ = 0.0;
};

} // namespace burin
