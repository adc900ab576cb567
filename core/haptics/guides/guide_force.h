// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/guides/guide_set.h"

namespace burin {

/// What of a guided hand reaches the force. Setup frame.
struct FeltGuides {
    glm::dvec3 from{0.0};   ///< mm: where the spring to the tool begins, in place of the hand
    glm::dvec3 pull{0.0};   ///< mm, for the guides' spring
    glm::dvec3 across{0.0}; ///< mm/s, for the guides' damper
};

/// Contact wins over guides: a guide that lies behind what holds the tool draws the hand no farther than to the tool,
/// and never presses it in; a hand beyond guide and contact feels the contact from the guide on. In both cases the
/// force is continuous in hand, goal and tool, and equal to the contact's alone while no guide holds.
/// @param hand where it wants the tool. @param tool where it came to
FeltGuides felt(const GuidedHand& guided, const glm::dvec3& hand, const glm::dvec3& tool) noexcept;

} // namespace burin
