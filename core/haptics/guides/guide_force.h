// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/guides/guide_set.h"

namespace burin {

/// The effect of the guides on the force. Setup frame.
struct FeltGuides {
    glm::dvec3 from{0.0};   ///< mm: where the spring to the tool starts, in place of the hand
    glm::dvec3 pull{0.0};   ///< mm, displacement of the guides' spring
    glm::dvec3 across{0.0}; ///< mm/s, velocity of the guides' damper
};

/// Contact wins over guides: a guide that lies behind the surface that holds the tool pulls the hand no farther than to
/// the tool, and never presses it in; if the hand is beyond guide and contact, it feels the contact from the guide on.
/// In both cases the force is continuous in hand, goal and tool, and equal to the contact force alone while no guide
/// holds the hand.
/// @param hand tip position requested by the hand. @param tool tip position reached
FeltGuides felt(const GuidedHand& guided, const glm::dvec3& hand, const glm::dvec3& tool) noexcept;

} // namespace burin
