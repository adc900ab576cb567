// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/known_moves.h"
#include "core/verify/move_samples.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Divides the samples along moves into batches whose borders depend only on the moves near by: where a program was
/// changed in one place, the batches elsewhere have the samples that they had. (Content-defined chunking: A.
/// Muthitacharoen, B. Chen, D. Mazières, A low-bandwidth network file system, 2001.)
/// @return the first sample of each batch, and the number of samples at the end
std::vector<std::size_t> batchBorders(const std::vector<ToolMove>& moves, const MoveSamples& samples);

/// What the samples of a batch are, and how they are judged: equal for equal samples.
using BatchKey = std::vector<std::uint64_t>;

/// @param numbers of the moves (KnownMoves) @param first, end  samples
/// @param isFinishing by move: whether it is at its tool's highest feed
BatchKey batchKeyOf(const std::vector<ToolMove>& moves, const MoveSamples& samples,
                    std::span<const std::uint32_t> numbers, const std::vector<std::uint8_t>& isFinishing,
                    std::size_t first, std::size_t end);

} // namespace burin
