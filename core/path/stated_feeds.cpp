// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/stated_feeds.h"

#include "core/path/stroke.h"

#include <algorithm>

namespace burin {

StatedFeeds::StatedFeeds(std::span<const SourceStrokes> sources) {
    for (const SourceStrokes& each : sources)
        if (!each.stated.empty()) stated_[each.info.source.id] = each.stated;
}

std::optional<StatedFeed> StatedFeeds::between(const Moment& from, const Moment& to) const {
    const auto source = stated_.find(to.source);
    if (source == stated_.end() || to.tick < 0) return std::nullopt;
    const std::vector<StatedFeed>& all = source->second;
    const bool within = from.source == to.source && from.tick >= 0;
    // Points that an edit inserted between two moments have the earlier one: from such a point, or to it, the stated
    // motion ends at the next moment.
    const std::int64_t first = within ? std::min(from.tick, to.tick) + 1 : to.tick;
    const std::int64_t last = within ? std::max({from.tick, to.tick, first}) : to.tick;
    std::optional<StatedFeed> least;
    std::optional<Coolant> coolant;
    for (auto at = std::ranges::lower_bound(all, first, {}, &StatedFeed::moment); at != all.end() && at->moment <= last;
         ++at) {
        coolant = std::max(coolant, at->coolant); // none of all is the least
        if (!least || at->feed < least->feed) least = *at;
    }
    if (least) least->coolant = coolant;
    return least;
}

bool StatedFeeds::coolantChangesAt(const Moment& moment) const {
    const auto source = stated_.find(moment.source);
    if (source == stated_.end()) return false;
    const auto at = std::ranges::lower_bound(source->second, moment.tick, {}, &StatedFeed::moment);
    return at != source->second.end() && at->moment == moment.tick && at + 1 != source->second.end() &&
           (at + 1)->coolant != at->coolant;
}

std::size_t StatedFeeds::bytes() const noexcept {
    std::size_t bytes = sizeof(StatedFeeds);
    for (const auto& [source, feeds] : stated_) bytes += sizeof(feeds) + feeds.capacity() * sizeof(StatedFeed);
    return bytes;
}

} // namespace burin
