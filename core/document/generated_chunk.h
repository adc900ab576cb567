// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recording/generated_moves.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Most points that one chunk holds, so that a damaged count can't ask for more memory than a chunk needs.
inline constexpr std::size_t pointsPerChunk = 16384;

/// A part of a stroke of generated moves; every bit of every value comes back. @param points at most `pointsPerChunk`
std::string encodePoints(std::span<const GeneratedPoint> points);

/// Nothing when the chunk is damaged, of a form that this version doesn't know, or not of exactly `count` points.
std::optional<std::vector<GeneratedPoint>> decodePoints(std::string_view chunk, std::size_t count);

} // namespace burin
