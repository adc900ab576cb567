// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/cutting_force_rendering.h"

#include "core/base/units.h"
#include "core/geometry/pose.h"

#include <algorithm>
#include <cmath>

namespace burin {

void CuttingForceRendering::reset() noexcept {
    yield_ = 0.0;
    sideways_ = glm::dvec3(0.0);
    anchored_ = false;
}

glm::dvec3 CuttingForceRendering::operator()(const CuttingForce& cut, const glm::dvec3& motion, const glm::dvec3& tip,
                                             double period) noexcept {
    if (!anchored_) anchor_ = tip;
    anchored_ = true;

    // What works against the motion, of either part, is friction and goes to the anchor; what is left of the radial
    // part pushes sideways.
    const double moved = glm::length(motion);
    const glm::dvec3 against = moved > 0.0 ? -motion / moved : glm::dvec3(0.0);
    const double resistance = std::max(0.0, glm::dot(cut.force, against));
    const glm::dvec3 sideways = moved > 0.0 ? cut.force - glm::dot(cut.force, against) * against : glm::dvec3(0.0);
    const double share = 1.0 - std::exp(-period / smoothing);
    yield_ += share * (settings_.scale * resistance - yield_);
    sideways_ += share * (settings_.scale * sideways - sideways_);
    // Below any device's resolution; without it the decay would end in denormal numbers, which are slow.
    if (yield_ < 1e-9) yield_ = 0.0;
    if (glm::length(sideways_) < 1e-9) sideways_ = glm::dvec3(0.0);

    if (settings_.stiffness <= 0.0) return glm::dvec3(0.0);
    const double yield = std::min(yield_, settings_.maximum);
    const double newtonPerMillimetre = settings_.stiffness / (settings_.workspaceScale * millimetresPerMetre);
    const glm::dvec3 stretch = clampLength(tip - anchor_, yield / newtonPerMillimetre);
    anchor_ = tip - stretch;
    return clampLength(-newtonPerMillimetre * stretch + sideways_, settings_.maximum);
}

} // namespace burin
