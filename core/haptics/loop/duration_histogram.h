// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace burin {

/// Counts durations in fixed memory: with a relative error of at most 1/32 of the value, whatever its size. Adding is a
/// few instructions.
class DurationHistogram {
public:
    /// @param nanoseconds negative counts as 0
    void add(std::int64_t nanoseconds) noexcept {
        const auto value = static_cast<std::uint64_t>(nanoseconds > 0 ? nanoseconds : 0);
        ++buckets_[bucket(value)];
        ++count_;
        if (value > largest_) largest_ = value;
    }
    std::uint64_t count() const noexcept { return count_; }
    double largestMicroseconds() const noexcept { return static_cast<double>(largest_) * 1e-3; }
    /// The duration in µs that a share of all durations does not exceed: the upper end of its bucket, never beyond the
    /// largest.
    /// @param share 0 … 1
    double quantileMicroseconds(double share) const noexcept;

private:
    static constexpr int subBits = 5; ///< 32 buckets for each power of two
    static constexpr std::size_t size = (64 - subBits + 1) << subBits;
    static std::size_t bucket(std::uint64_t value) noexcept {
        const int excess = static_cast<int>(std::bit_width(value)) - subBits - 1;
        const int shift = excess > 0 ? excess : 0;
        return (static_cast<std::size_t>(shift) << subBits) + static_cast<std::size_t>(value >> shift);
    }
    std::array<std::uint64_t, size> buckets_{};
    std::uint64_t count_ = 0, largest_ = 0;
};

} // namespace burin
