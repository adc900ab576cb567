// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"
#include "core/cad/model.h"
#include "core/document/project.h"
#include "core/passes/pass_request.h"

#include <optional>
#include <string>
#include <vector>

namespace burin {

/// What the command line says of a computed pass, as it was written.
struct PassArguments {
    std::string kind, tool, area, lines, move, unit;
    std::vector<std::int64_t> leads, paint;
    std::vector<std::string> faces;      ///< places on the part
    std::vector<std::string> holes;      ///< places in plan
    double brush = 10.0;                 ///< mm, diameter
    std::optional<std::int64_t> instead; ///< id of the pass whose place it takes
    bool preview = false;                ///< nothing is kept
    double directionDegrees = 0.0;
    std::optional<double> flattestDegrees, steepestDegrees;
    PassRequest request;
};

/// Declares --pass and all that belongs to it. @param arguments outlives the parsing
/// @return --pass itself
Argument addPass(CommandParser command, PassArguments& arguments);

/// The request that they make. @param part as it lies in the setup
/// Errors: those of readDrawing, linesOfTake, faceArea and validate; argumentInvalid.
Result<PassRequest> requestOf(const PassArguments& arguments, const Project& project, const Model& part,
                              CommandContext& context);

} // namespace burin
