// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/force/passivity_controller.h"

#include <algorithm>

namespace burin {

PassivityController::PassivityController(const Settings& settings) noexcept : settings_(settings) {
    if (settings_.delay < 0 || settings_.delay > longestDelay) settings_.delay = 0;
}

void PassivityController::reset() noexcept {
    energy_ = 0.0;
    sent_.fill(glm::dvec3(0.0));
}

void PassivityController::sent(const glm::dvec3& force) noexcept {
    newest_ = (newest_ + 1) % sent_.size();
    sent_[newest_] = force;
}

glm::dvec3 PassivityController::dampen(const glm::dvec3& force, const Motion& hand, double period) noexcept {
    // The device applied this force during the whole tick: the product is exact, not an estimate.
    const glm::dvec3& acted =
        sent_[(newest_ + sent_.size() - static_cast<std::size_t>(settings_.delay)) % sent_.size()];
    energy_ = std::min(energy_ - glm::dot(acted, hand.moved), largestCredit);
    if (energy_ >= -allowedDeficit || glm::length(hand.velocity) <= settings_.slowest) return force;
    const double missing = -(energy_ + allowedDeficit);
    const double damping = std::min(hand.rests ? settings_.restingDamping : settings_.damping,
                                    missing / (period * glm::dot(hand.velocity, hand.velocity)));
    return force - damping * hand.velocity;
}

} // namespace burin
