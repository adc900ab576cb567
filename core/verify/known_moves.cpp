// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/known_moves.h"

#include <bit>

namespace burin {

MoveValue::MoveValue(const ToolMove& move) noexcept {
    const ToolPose &from = move.begin(), &to = move.to;
    std::size_t word = 0;
    for (const glm::dvec3& value : {from.tip, from.axis, to.tip, to.axis})
        for (int axis = 0; axis < 3; ++axis) words_[word++] = std::bit_cast<std::uint64_t>(value[axis]);
    words_[word] = std::uint64_t{move.tool} << 1U | (move.rapid ? 1U : 0U);
    // The finishing steps of SplitMix64 (Steele, Lea & Flood 2014), word by word.
    for (const std::uint64_t each : words_) {
        hash_ = (hash_ ^ each) + 0x9e3779b97f4a7c15U;
        hash_ = (hash_ ^ (hash_ >> 30U)) * 0xbf58476d1ce4e5b9U;
        hash_ = (hash_ ^ (hash_ >> 27U)) * 0x94d049bb133111ebU;
        hash_ ^= hash_ >> 31U;
    }
}

std::vector<std::uint32_t> KnownMoves::numbersOf(const std::vector<ToolMove>& moves) {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(moves.size());
    for (const ToolMove& move : moves)
        numbers.push_back(
            numbers_.try_emplace(MoveValue(move), static_cast<std::uint32_t>(numbers_.size())).first->second);
    return numbers;
}

std::size_t KnownMoves::bytes() const noexcept {
    constexpr std::size_t node = 2 * sizeof(void*); // of the table, for each entry
    return numbers_.size() * (sizeof(MoveValue) + sizeof(std::uint32_t) + node) +
           numbers_.bucket_count() * sizeof(void*);
}

} // namespace burin
