// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recording/sample.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// The largest number of samples in one chunk, so that a damaged count can't request more memory than a chunk needs.
inline constexpr std::size_t samplesPerChunk = 16384;

/// Encodes a part of a recording as compactly as its noise allows, without loss of any bit.
/// @param samples at most `samplesPerChunk`
std::string encodeSamples(std::span<const Sample> samples);

/// Empty if the chunk is damaged, of a form that this version doesn't know, or not of exactly `count` samples.
std::optional<std::vector<Sample>> decodeSamples(std::string_view chunk, std::size_t count);

} // namespace burin
