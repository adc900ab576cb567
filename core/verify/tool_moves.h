// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"
#include "core/geometry/upright.h"
#include "core/machine/machine_profile.h"
#include "core/nc/parser.h"
#include "core/tool/tool.h"

#include <span>
#include <vector>

namespace burin {

/// A straight move of the tool in the setup frame: a motion of the program, or a part of one.
struct ToolMove {
    ToolPose from, to; ///< setup frame
    double feed = 0.0; ///< mm/min; 0 for rapids
    std::uint32_t line = 0;
    std::uint32_t motion = 0; ///< index in ParsedProgram::motions
    std::uint16_t tool = 0;   ///< index among the tools that the moves were made with
    bool rapid = false;
    bool spindleOn = false;
    bool startKnown = true; ///< false: `from` is not set by the program; the tool is assumed to appear at `to`
    bool endKnown = true;   ///< false: `to` is not set either; the move can't be judged

    /// Where the part of the move that is judged begins.
    const ToolPose& begin() const noexcept { return startKnown ? from : to; }
    /// Whether the tool is not upright on all of the move.
    bool tilted() const noexcept { return !isUpright(begin().axis) || !isUpright(to.axis); }
    /// The pose at a fraction of the move, on which the tool turns evenly.
    ToolPose poseAt(double share) const noexcept {
        const ToolPose& start = begin();
        const glm::dvec3 axis = tilted() ? glm::normalize(glm::mix(start.axis, to.axis, share)) : to.axis;
        return {glm::mix(start.tip, to.tip, share), axis};
    }
    /// The axis in the middle of the move: the tool turns by no more than `finestTurn` on it.
    glm::dvec3 middleAxis() const noexcept { return tilted() ? glm::normalize(begin().axis + to.axis) : uprightAxis; }
};

/// Moves on which rotary axes turn are divided so that none turns by more than this on a part, degrees. The cut of a
/// part is that of its middle axis: flutes of 20 mm are off by 0.02 mm at most.
inline constexpr double finestTurn = 0.1;

/// Largest deviation of the chords as which arcs are judged, mm.
inline constexpr double arcChord = 0.001;

/// The moves of a program in the setup frame, as the machine makes them: arcs as chords (`arcChord`), rapids along the
/// path of the machine's mode (`rapidWay`), moves on which the tool tilts in parts (`finestTurn`), without dwells.
/// Until a program has set an axis, the machine may be anywhere on it; rotary axes that a program never names are at 0.
/// @param toolOf index of the tool, by motion; empty: all have the first
/// @param largestTurn of a rotary axis on a part of a move, degrees
std::vector<ToolMove> toolMoves(const ParsedProgram& program, const glm::dvec3& workOffset,
                                const MachineProfile& machine, std::span<const std::uint16_t> toolOf = {},
                                double largestTurn = finestTurn);

/// The corners of a rapid's path after its start, ending with its end. Independent axes move at their own constant
/// rates until they arrive: up to three straight segments. The rounding of these corners by accelerations is left out.
std::vector<glm::dvec3> rapidWay(const glm::dvec3& from, const glm::dvec3& to, const MachineProfile& machine);

} // namespace burin
