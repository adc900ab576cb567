// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"

namespace burin {

/// What became of the hand's wish in one tick. Setup frame.
struct ToolMotion {
    ToolPose from, to;
    glm::dvec3 normal{0.0};     ///< unit, of what bounds the tool where it holds it; zero when free
    glm::dvec3 turnBehind{0.0}; ///< rad, rotation vector: takes the hand's axis to the tool's; zero with a fixed axis
    bool shankContact = false;  ///< shank or holder touch, or would
    bool barred = false;        ///< the tool stays although the part would let it go
    bool axisHeld = false;      ///< the axis does not follow the hand: no room is left, and the hand can't feel it

    glm::dvec3 way() const noexcept { return to.tip - from.tip; } ///< mm, of the tip
};

} // namespace burin
