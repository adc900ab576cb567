// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// One straight move as the machine makes it.
struct NcMotion {
    bool rapid = false;
    glm::dvec3 from{0.0}, to{0.0}; ///< mm, in the frame of the work offset in force; `from` of the first is unknown
    /// False for axes that no block has set before, or not since a tool change, another work offset or (Z) another
    /// length offset. `from` is then without meaning on that axis, and so is `to` where the block does not set it.
    bool fromKnown[3] = {true, true, true};
    double feed = 0.0; ///< mm/min; 0 for rapids
    bool spindleOn = false;
    int tool = 0;           ///< loaded
    std::uint32_t line = 0; ///< of the text, from 1
};

/// What a program does, read back from its text.
struct ParsedProgram {
    std::vector<NcMotion> motions;
    std::size_t blocks = 0;           ///< lines that hold at least one word
    double maximumSpindleSpeed = 0.0; ///< 1/min
    int workOffset = 54;              ///< in force at the end: 54 for G54
    bool ended = false;               ///< M2, M30 or a closing %
};

/// Reads the RS274 words that Burin's LinuxCNC post-processor writes, and their close kin: G0 G1 G2 G3 (arcs by I J K,
/// incremental, planes G17 G18 G19; flattened to a chord of 0.001 mm) G4 G17–G21 G40 G43 G49 G54–G59 G61 G64 G80 G90
/// G91 G91.1 G94, M0 M1 M2 M3 M4 M5 M6 M7 M8 M9 M30, F S T H P Q N, comments, block delete, %. Anything else is an
/// error with line and column, never ignored. Lengths are millimetres until G20. Blocks behind / are carried out (block
/// delete off). Feeds must be given; incremental moves and arcs from an unknown place are errors. What stands behind a
/// closing % is not read. Cost: linear; more than a million lines a second. Errors: programSyntax.
/// @param origin file name for messages
Result<ParsedProgram> parseProgram(std::string_view text, const std::string& origin);

} // namespace burin
