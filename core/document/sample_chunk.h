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

/// Most samples that one chunk holds, so that a damaged count can't ask for more memory than a chunk needs.
inline constexpr std::size_t samplesPerChunk = 16384;

/// A stretch of a recording in as few bytes as its noise allows; every bit of every value comes back.
/// @param samples at most `samplesPerChunk`
std::string encodeSamples(std::span<const Sample> samples);

/// Nothing when the chunk is damaged, of a form that this version doesn't know, or not of exactly `count` samples.
std::optional<std::vector<Sample>> decodeSamples(std::string_view chunk, std::size_t count);

} // namespace burin
