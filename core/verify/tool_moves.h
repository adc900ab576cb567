// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/parser.h"

#include <vector>

namespace burin {

/// A move of the tip in the setup frame.
struct ToolMove {
    glm::dvec3 from{0.0}, to{0.0}; ///< mm
    double feed = 0.0;             ///< mm/min; 0 for rapids
    std::uint32_t line = 0;
    bool rapid = false;
    bool spindleOn = false;
    bool startKnown = true; ///< false: `from` is not set by the program; the tool is taken to appear at `to`
};

/// Moves of a program in the setup frame. Until a program has set an axis the machine may stand anywhere on it.
std::vector<ToolMove> toolMoves(const ParsedProgram& program, const glm::dvec3& workOffset);

} // namespace burin
