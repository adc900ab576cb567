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

/// Identifies a source of a path: a take has an id above 0, generated moves have one below, so that a moment identifies
/// either by one number.
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
    double allowance = 0.0;  ///< mm of stock that it leaves on the part
    double tickPeriod = 0.0; ///< s between its samples; 0: it has no timing
    bool copy = false;       ///< of a take that is not removed: not added to paths automatically
};

/// Its name in messages and in comments of programs: "take 3", "pass 1".
std::string nameOf(PathSource source);

SourceInfo sourceOf(const TakeInfo& take);
SourceInfo sourceOf(const GeneratedInfo& generated);

} // namespace burin
