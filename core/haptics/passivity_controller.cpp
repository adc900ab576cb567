// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/passivity_controller.h"

#include "core/base/units.h"

#include <algorithm>

namespace burin {

void PassivityController::reset() noexcept {
    energy_ = 0.0;
    sent_ = glm::dvec3(0.0);
    known_ = false;
}

glm::dvec3 PassivityController::operator()(const glm::dvec3& force, const glm::dvec3& position,
                                           const glm::dvec3& velocity, double period) noexcept {
    // The device held the force sent last over the whole tick: this product is exact, not an estimate.
    if (known_) energy_ -= glm::dot(sent_, position - position_) / millimetresPerMetre;
    energy_ = std::min(energy_, largestCredit);
    position_ = position;
    known_ = true;
    if (energy_ >= -allowedDeficit || glm::length(velocity) <= slowest) return force;
    const glm::dvec3 metresPerSecond = velocity / millimetresPerMetre;
    const double missing = -(energy_ + allowedDeficit);
    const double damping = std::min(maximumDamping_, missing / (period * glm::dot(metresPerSecond, metresPerSecond)));
    return force - damping * metresPerSecond;
}

} // namespace burin
