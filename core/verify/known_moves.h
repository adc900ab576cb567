// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/tool_moves.h"

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace burin {

/// What the path of a tool on a move depends on, bit for bit: the poses where it begins and ends, the tool, and
/// whether it is a rapid. Feed, spindle and line are not included.
class MoveValue {
public:
    explicit MoveValue(const ToolMove& move) noexcept;
    /// For tables, and for borders that depend on the moves alone.
    std::uint64_t hash() const noexcept { return hash_; }
    friend bool operator==(const MoveValue& one, const MoveValue& other) noexcept { return one.words_ == other.words_; }

private:
    std::array<std::uint64_t, 13> words_{};
    std::uint64_t hash_ = 0;
};

/// Numbers moves from 0 so that moves of equal value have the same number, in all programs that were numbered.
class KnownMoves {
public:
    /// By index in `moves`.
    std::vector<std::uint32_t> numbersOf(const std::vector<ToolMove>& moves);
    std::size_t count() const noexcept { return numbers_.size(); }
    std::size_t bytes() const noexcept;

private:
    struct Hash {
        std::size_t operator()(const MoveValue& value) const noexcept { return value.hash(); }
    };
    std::unordered_map<MoveValue, std::uint32_t, Hash> numbers_;
};

} // namespace burin
