// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recording/sample.h"
#include "core/tool/tool.h"

#include <cstdint>

namespace burin {

/// What an upright tool is held against, as an edge finder tells it.
struct TouchedFace {
    enum class Outcome : std::uint8_t {
        found,
        nothing, ///< nothing holds the tool back
        aslant   ///< the tool leans, or the face is along no plane of two axes
    };
    Outcome outcome = Outcome::nothing;
    int axis = 0;          ///< 0, 1, 2: that the face stands across
    glm::dvec3 place{0.0}; ///< mm, setup frame: where the tool touches
};

/// From which side a boundary pushes the tool back, and where: a side face by the cutter's radius, a face below by its
/// tip. @param allowance mm that the boundary lies before the face
TouchedFace touchedFace(const Sample& sample, const Tool& tool, double allowance);

} // namespace burin
