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

/// The largest number of points in one chunk, so that a damaged count can't request more memory than a chunk needs.
inline constexpr std::size_t pointsPerChunk = 16384;

/// Encodes a part of a stroke of generated moves without loss of any bit. @param points at most `pointsPerChunk`
std::string encodePoints(std::span<const GeneratedPoint> points);

/// Empty if the chunk is damaged, of a form that this version doesn't know, or not of exactly `count` points.
std::optional<std::vector<GeneratedPoint>> decodePoints(std::string_view chunk, std::size_t count);

} // namespace burin
