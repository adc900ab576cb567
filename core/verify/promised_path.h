// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/findings.h"
#include "core/verify/tool_moves.h"

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Where the end of a motion lies relative to the paths that the program is to follow.
enum class PathSide : std::uint8_t {
    unknown, ///< a rapid, a tool without a path, an end that the program does not set
    on,
    off
};

/// The comparison of a program with the paths that it is to follow.
struct PathComparison {
    std::vector<PathSide> ends; ///< by index in ParsedProgram::motions; empty: there are no paths
};

/// Compares feed moves with `request.promised`, tool by tool. Where the nearest path is within 3 mm of a point of a
/// move, and its tool within 1 mm of the part, the clearance of the program's tool from the part has to equal that on
/// the path, to `request.excessTolerance`: a greater clearance is excess, a smaller one means that part of the
/// allowance is gone. Both clearances are exact on the mesh. Examined every millimetre of every move.
/// @param tools indexed by ToolMove::tool. Errors: cancelled.
Result<PathComparison> comparePaths(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                                    const VerifyRequest& request, Findings& findings, const Progress& progress);

} // namespace burin
