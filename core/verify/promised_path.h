// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/findings.h"
#include "core/verify/tool_moves.h"

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Where the end of a motion lies, beside the paths that the program was to follow.
enum class PathSide : std::uint8_t {
    unknown, ///< a rapid, a tool without a path, an end that the program does not set
    on,
    off
};

/// A program held against the paths that it was to follow.
struct PathComparison {
    std::vector<PathSide> ends; ///< by place in ParsedProgram::motions; empty: there are no paths
};

/// Compares feed moves with `request.promised`, tool by tool. Where the path nearest to a place of one, within 3 mm,
/// comes within 1 mm of the part, the tool has to be as far from the part as the path's, to `request.excessTolerance`:
/// farther is excess, nearer a part of the allowance that is gone. Both clearances are exact on the mesh. Looked at
/// every millimetre of every move.
/// @param tools those that ToolMove::tool counts. Errors: cancelled.
Result<PathComparison> comparePaths(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                                    const VerifyRequest& request, Findings& findings, const Progress& progress);

} // namespace burin
