// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"

namespace burin {

/// The tool's motion in one tick in response to the hand's request. Setup frame.
struct ToolMotion {
    ToolPose from, to;
    glm::dvec3 normal{0.0};     ///< unit, of the boundary that holds the tool; zero when free
    glm::dvec3 turnBehind{0.0}; ///< rad, rotation vector from the hand's axis to the tool's; zero with a fixed axis
    bool shankContact = false;  ///< shank or holder are in contact, or would be
    bool barred = false;        ///< the tool stays although the boundary would allow a motion
    bool axisHeld = false; ///< the axis does not follow the hand because there is no room, and the hand can't feel it

    glm::dvec3 way() const noexcept { return to.tip - from.tip; } ///< mm, of the tip
};

} // namespace burin
