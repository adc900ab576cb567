// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"

namespace burin {

/// What became of the hand's wish in one tick. Setup frame.
struct ToolMotion {
    ToolPose from, to;
    glm::dvec3 normal{0.0};    ///< unit, of the part's boundary where it holds the tool; zero when free
    bool shankContact = false; ///< shank or holder touch, or would
    bool barred = false;       ///< the tool stays although the part would let it go

    glm::dvec3 way() const noexcept { return to.tip - from.tip; } ///< mm, of the tip
};

} // namespace burin
