// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_values.h"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace burin {

struct SourceStrokes;

/// What a program states of the motion that ends at a moment of its source.
struct StatedFeed {
    std::int64_t moment = 0;
    double feed = 0.0;         ///< mm/min, above 0
    double spindleSpeed = 0.0; ///< 1/min; 0: not stated
};

/// What the programs among a path's sources state of their motions, whatever edits made of these.
class StatedFeeds {
public:
    explicit StatedFeeds(std::span<const SourceStrokes> sources);

    bool empty() const noexcept { return stated_.empty(); }
    bool holds(std::int64_t source) const { return stated_.contains(source); }
    /// Of a motion from one moment to another: where an edit made one motion of several, the least feed of them.
    /// Nothing: none is stated.
    std::optional<StatedFeed> between(const Moment& from, const Moment& to) const;

private:
    std::map<std::int64_t, std::vector<StatedFeed>> stated_; ///< by source; moments rise
};

} // namespace burin
