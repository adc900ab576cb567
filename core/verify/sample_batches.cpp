// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/sample_batches.h"

#include <algorithm>

namespace burin {

namespace {

constexpr std::size_t usualBatch = 256;    // samples
constexpr std::size_t longestBatch = 4096; // samples: where no border follows from the moves

} // namespace

/// A border is where a move begins whose hash, modulo the usual number of samples, is less than its own number of them;
/// long moves have more borders, at equal numbers of samples from their start.
std::vector<std::size_t> batchBorders(const std::vector<ToolMove>& moves, const MoveSamples& samples) {
    std::vector<std::size_t> borders{0};
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const std::size_t first = samples.firstOf(i), end = samples.firstOf(i + 1);
        const bool begins = MoveValue(moves[i]).hash() % usualBatch < end - first;
        if (first > borders.back() && (begins || first - borders.back() >= longestBatch)) borders.push_back(first);
        for (std::size_t at = first + usualBatch; at + usualBatch <= end; at += usualBatch) borders.push_back(at);
    }
    if (borders.back() < samples.count()) borders.push_back(samples.count());
    return borders;
}

BatchKey batchKeyOf(const std::vector<ToolMove>& moves, const MoveSamples& samples,
                    std::span<const std::uint32_t> numbers, const std::vector<std::uint8_t>& isFinishing,
                    std::size_t first, std::size_t end) {
    BatchKey key;
    const std::size_t start = samples.moveOf(first);
    for (std::size_t i = start; i < moves.size() && samples.firstOf(i) < end; ++i) {
        const std::size_t from = std::max(first, samples.firstOf(i)), to = std::min(end, samples.firstOf(i + 1));
        if (from >= to) continue;
        const bool ofAll = samples.firstOf(i) == 0; // the start of the first move is a sample of its own
        key.push_back(std::uint64_t{numbers[i]} << 2U | std::uint64_t{isFinishing[i] != 0} << 1U | (ofAll ? 1U : 0U));
        key.push_back((i - start) << 32U | (from - samples.firstOf(i)));
        key.push_back(to - from);
    }
    return key;
}

} // namespace burin
