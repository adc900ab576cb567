// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/force/plastic_anchor.h"

#include <algorithm>
#include <cmath>

namespace burin {

PlasticAnchor::PlasticAnchor(double stiffness, double mostForce) noexcept
    : stiffness_(stiffness), mostCredit_(stiffness > 0.0 ? 0.5 * mostForce * mostForce / stiffness : 0.0) {}

void PlasticAnchor::setStiffness(double stiffness) noexcept {
    if (!(stiffness > 0.0) || !(stiffness_ > 0.0)) return;
    const double share = stiffness_ / stiffness; // ratio of all lengths, and so of the energies at the same force
    stiffness_ = stiffness;
    interval_ *= share;
    credit_ *= share;
    mostCredit_ *= share;
}

void PlasticAnchor::reset() noexcept {
    interval_ = glm::dvec3(0.0);
    credit_ = 0.0;
    drags_ = false;
}

glm::dvec3 PlasticAnchor::drag(const glm::dvec3& motion, const Yield& yield) noexcept {
    if (!(stiffness_ > 0.0)) return glm::dvec3(0.0);
    const bool goesOn = drags_ && glm::dot(interval_, motion) >= 0.0;
    // The device applied the force of the last tick during the whole motion: this product is exact.
    credit_ += stiffness_ * (glm::dot(interval_, motion) + 0.5 * glm::dot(interval_, interval_));
    interval_ += motion;
    const double length = glm::length(interval_), limit = yield.force / stiffness_;
    double wanted = std::min(length, limit);
    if (goesOn && length < limit)
        wanted = std::clamp(std::sqrt(2.0 * std::max(0.0, credit_) / stiffness_), length, limit);
    drags_ = length > 0.0 && (length >= limit || goesOn);
    if (length > 0.0) interval_ *= wanted / length;
    const double along = glm::dot(interval_, yield.across), most = yield.along / stiffness_;
    interval_ -= (along - std::clamp(along, -most, most)) * yield.across;
    credit_ = std::min(credit_ - 0.5 * stiffness_ * glm::dot(interval_, interval_), mostCredit_);
    return -stiffness_ * interval_;
}

} // namespace burin
