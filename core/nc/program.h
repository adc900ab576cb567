// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace burin {

enum class NcMoveKind : std::uint8_t { rapid, line };

/// One straight move of a program, before a dialect words it.
struct NcMove {
    NcMoveKind kind = NcMoveKind::line;
    glm::dvec3 target{0.0};    ///< mm, in the frame of the work offset in force
    double feed = 0.0;         ///< mm/min; 0 for rapids
    std::int64_t take = 0;     ///< the hand's moment behind it, as in PathPoint
    std::int64_t sample = -1;
    std::string comment;       ///< stands before the move; empty: none
};

/// A program for one tool, before a dialect words it.
struct NcProgram {
    std::string name;
    std::vector<std::string> header; ///< comment lines
    int workOffset = 54;             ///< G word
    int toolNumber = 1;
    std::string toolName;
    double spindleSpeed = 0.0;       ///< 1/min, clockwise
    bool coolant = false;
    double safeHeight = 0.0;         ///< mm above the work offset's zero, where travel is free
    double blendTolerance = 0.0;     ///< mm that the control may leave the path by
    std::vector<NcMove> moves;
};

} // namespace burin
