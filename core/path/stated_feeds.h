// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/coolant.h"
#include "core/path/edit_values.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace burin {

struct SourceStrokes;

/// Feed, speed and coolant that a program states for the motion ending at a moment of its source.
struct StatedFeed {
    std::int64_t moment = 0;
    double feed = 0.0;         ///< mm/min, above 0
    double spindleSpeed = 0.0; ///< 1/min; 0: not stated
    std::optional<Coolant> coolant{};
};

/// The feeds stated by the programs among a path's sources, independent of edits.
class StatedFeeds {
public:
    explicit StatedFeeds(std::span<const SourceStrokes> sources);

    bool empty() const noexcept { return stated_.empty(); }
    std::size_t bytes() const noexcept; ///< of memory
    bool holds(std::int64_t source) const { return stated_.contains(source); }
    /// The feed for a motion from one moment to another: if an edit merged several motions into one, the least of their
    /// feeds, and of their coolants flood before mist before none. Empty if none is stated.
    std::optional<StatedFeed> between(const Moment& from, const Moment& to) const;
    /// Whether the coolant of the motion that begins at a moment differs from that of the motion that ends there.
    bool coolantChangesAt(const Moment& moment) const;

private:
    std::map<std::int64_t, std::vector<StatedFeed>> stated_; ///< by source; moments ascend
};

} // namespace burin
