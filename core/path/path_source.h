// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recording/generated_moves.h"
#include "core/recording/sample.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// Something that a path is made of, by its id: a take has a number above 0, generated moves have one below, so that a
/// moment names either by one number.
struct PathSource {
    std::int64_t id = 0; ///< TakeInfo::id or GeneratedMoves::id

    bool isTake() const noexcept { return id > 0; }
    bool isGenerated() const noexcept { return id < 0; }
    friend bool operator==(const PathSource&, const PathSource&) = default;
};

/// Ids of the takes among sources, in their order.
std::vector<std::int64_t> takesOf(std::span<const PathSource> sources);
std::vector<PathSource> sourcesOf(std::span<const std::int64_t> takes);

/// What is known of a source without its moves.
struct SourceInfo {
    PathSource source;
    std::string toolId;
    double allowance = 0.0;  ///< mm that it leaves on the part
    double tickPeriod = 0.0; ///< s of the hand's time; 0: it has none
};

/// As messages and comments of programs name it: "take 3", "pass 1".
std::string nameOf(PathSource source);

SourceInfo sourceOf(const TakeInfo& take);
SourceInfo sourceOf(const GeneratedInfo& generated);

} // namespace burin
