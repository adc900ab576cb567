// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/passivity_controller.h"

#include "core/base/units.h"

#include <algorithm>

namespace burin {

PassivityController::PassivityController(const Settings& settings) noexcept : settings_(settings) {
    if (settings_.delay < 0 || settings_.delay > longestDelay) settings_.delay = 0;
}

void PassivityController::reset() noexcept {
    energy_ = 0.0;
    sent_.fill(glm::dvec3(0.0));
    known_ = false;
}

void PassivityController::sent(const glm::dvec3& force) noexcept {
    newest_ = (newest_ + 1) % sent_.size();
    sent_[newest_] = force;
}

glm::dvec3 PassivityController::operator()(const glm::dvec3& force, const Hand& hand, double period) noexcept {
    const glm::dvec3& position = hand.device.position;
    // The device held this force over the whole tick: the product is exact, not an estimate.
    const glm::dvec3& acted =
        sent_[(newest_ + sent_.size() - static_cast<std::size_t>(settings_.delay)) % sent_.size()];
    if (known_) energy_ -= glm::dot(acted, position - position_) / millimetresPerMetre;
    energy_ = std::min(energy_, largestCredit);
    position_ = position;
    known_ = true;
    if (energy_ >= -allowedDeficit || glm::length(hand.deviceVelocity) <= slowest) return force;
    const glm::dvec3 velocity = hand.deviceVelocity / millimetresPerMetre; // m/s
    const double missing = -(energy_ + allowedDeficit);
    const double damping = std::min(hand.rests ? settings_.restingDamping : settings_.damping,
                                    missing / (period * glm::dot(velocity, velocity)));
    return force - damping * velocity;
}

} // namespace burin
