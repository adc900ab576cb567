// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/write_queue.h"

#include <algorithm>

namespace burin {

WriteQueue::WriteQueue(std::size_t bricks) : links_(bricks) {}

void WriteQueue::add(std::uint32_t brick) noexcept {
    const auto due = static_cast<std::uint8_t>((tick_ + longestDelay - 1) % longestDelay);
    links_[brick] = {last_, none, due, true};
    (last_ == none ? first_ : links_[last_].after) = brick;
    last_ = brick;
    ++dueCounts_[due];
    ++count_;
}

void WriteQueue::remove(std::uint32_t brick) noexcept {
    Link& link = links_[brick];
    (link.before == none ? first_ : links_[link.before].after) = link.after;
    (link.after == none ? last_ : links_[link.after].before) = link.before;
    --dueCounts_[link.due];
    --count_;
    link = {};
}

std::uint32_t WriteQueue::pace() const noexcept {
    std::uint32_t due = 0, pace = 0;
    for (std::uint32_t ahead = 0; ahead < longestDelay; ++ahead) {
        due += dueCounts_[(tick_ + ahead) % longestDelay];
        if (due > pace * (ahead + 1)) pace = (due + ahead) / (ahead + 1);
    }
    return pace;
}

void WriteQueue::clear() noexcept {
    std::fill(links_.begin(), links_.end(), Link{});
    first_ = last_ = none;
    count_ = 0;
    dueCounts_ = {};
}

} // namespace burin
