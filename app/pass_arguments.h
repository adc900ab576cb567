// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"
#include "core/document/project.h"
#include "core/passes/pass_request.h"

#include <optional>
#include <string>
#include <vector>

namespace burin {

/// What the command line says of a computed pass, as it was written.
struct PassArguments {
    std::string kind, tool, area, lines, move, unit;
    std::vector<std::int64_t> leads;
    double directionDegrees = 0.0;
    std::optional<double> flattestDegrees, steepestDegrees;
    PassRequest request;
};

/// Declares --pass and all that belongs to it. @param arguments outlives the parsing
/// @return --pass itself
Argument addPass(CommandParser command, PassArguments& arguments);

/// The request that they make. Errors: those of readDrawing, linesOfTake and validate; argumentInvalid.
Result<PassRequest> requestOf(const PassArguments& arguments, const Project& project, CommandContext& context);

} // namespace burin
