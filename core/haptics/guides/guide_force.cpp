// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/guides/guide_force.h"

#include <algorithm>

namespace burin {

FeltGuides felt(const GuidedHand& guided, const glm::dvec3& hand, const glm::dvec3& tool) noexcept {
    FeltGuides felt{guided.goal.tip, guided.pull, guided.across};
    const glm::dvec3 kept = tool - guided.goal.tip;
    const double length = glm::length(kept);
    if (!(length > 1e-9)) return felt;
    const glm::dvec3 outwards = kept / length; // away from the surface that keeps the tool from the goal
    felt.across -= outwards * glm::dot(outwards, felt.across);
    const double inFront = glm::dot(outwards, hand - guided.goal.tip); // of the goal, if the guide pulls inwards
    if (inFront <= 0.0) return felt;
    felt.from += outwards * std::min(inFront, length);
    const double inwards = glm::dot(outwards, felt.pull);
    // share of that distance in front of the contact
    const double outside = std::clamp((inFront - length) / inFront, 0.0, 1.0);
    if (inwards < 0.0) felt.pull += outwards * (inwards * (outside - 1.0));
    return felt;
}

} // namespace burin
