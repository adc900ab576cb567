// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"
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
    std::uint32_t motion = 0; ///< place in ParsedProgram::motions
    std::uint16_t tool = 0;   ///< place among the tools that the moves were made with
    bool rapid = false;
    bool spindleOn = false;
    bool startKnown = true; ///< false: `from` is not set by the program; the tool is taken to appear at `to`
    bool endKnown = true;   ///< false: nor is `to`; where the tool goes can't be judged

    /// Where the judged part of the move begins.
    const ToolPose& begin() const noexcept { return startKnown ? from : to; }
};

/// Arcs are judged as chords that leave them by no more than this, mm.
inline constexpr double arcChord = 0.001;

/// Moves of a program in the setup frame, as the machine makes them: arcs in chords (`arcChord`), rapids along the way
/// that the machine's mode takes (`rapidWay`), dwells left out. Until a program has set an axis the machine may stand
/// anywhere on it.
/// @param toolOf by motion, place of its tool; empty: all have the first
std::vector<ToolMove> toolMoves(const ParsedProgram& program, const glm::dvec3& workOffset,
                                const MachineProfile& machine, std::span<const std::uint16_t> toolOf = {});

/// Corners of a rapid's way behind its start, ending in its end. Independent axes go at their own rates until they are
/// there, at constant rate: up to three straight stretches. What their accelerations bend of these corners is left out.
std::vector<glm::dvec3> rapidWay(const glm::dvec3& from, const glm::dvec3& to, const MachineProfile& machine);

} // namespace burin
