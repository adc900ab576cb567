// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recording/sample.h"
#include "core/tool/tool.h"

#include <cstdint>

namespace burin {

/// The face that stops an upright tool, as found by an edge finder.
struct TouchedFace {
    enum class Outcome : std::uint8_t {
        found,
        nothing, ///< nothing holds the tool back
        aslant   ///< the tool is tilted, or the face is not parallel to a plane of two axes
    };
    Outcome outcome = Outcome::nothing;
    int axis = 0;        ///< 0, 1, 2: the axis that the face is perpendicular to
    bool high = false;   ///< of the two faces of a block along this axis, the one at the larger coordinate
    glm::dvec3 tip{0.0}; ///< mm, setup frame: of the tool
    /// mm, setup frame: where the tool touches. For a side face at the height at which a ball or a rounded edge reaches
    /// the cutter's radius, as there the contact is certain.
    glm::dvec3 place{0.0};
};

/// Returns the side and the position at which a boundary pushes the tool back: a side face is found with the cutter's
/// radius, a face below with its tip. @param allowance distance of the boundary in front of the face, mm
TouchedFace touchedFace(const Sample& sample, const Tool& tool, double allowance);

} // namespace burin
