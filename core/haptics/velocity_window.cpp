// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/velocity_window.h"

namespace burin {

void VelocityWindow::add(const glm::dvec3& position, double period) noexcept {
    time_ = count_ == 0 ? 0.0 : time_ + period;
    if (count_ == 0) oldest_ = 0;
    if (count_ == capacity) {
        oldest_ = (oldest_ + 1) % capacity;
        --count_;
    }
    entries_[(oldest_ + count_) % capacity] = {position, time_};
    ++count_;
    // The oldest entry is the youngest that lies a whole window back.
    while (count_ > 2 && time_ - entries_[(oldest_ + 1) % capacity].time >= length) {
        oldest_ = (oldest_ + 1) % capacity;
        --count_;
    }
    const Entry& from = entries_[oldest_];
    const double span = time_ - from.time;
    velocity_ = span > 0.0 ? (position - from.position) / span : glm::dvec3(0.0);
}

} // namespace burin
