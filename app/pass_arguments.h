// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"
#include "app/hole_arguments.h"
#include "core/cad/model.h"
#include "core/document/project.h"
#include "core/passes/pass_request.h"

#include <optional>
#include <string>
#include <vector>

namespace burin {

/// The arguments for a computed pass, as given by the user.
struct PassArguments {
    std::string kind, tool, area, lines, move, unit, hand{"ignore"};
    std::vector<std::int64_t> leads, paint;
    std::vector<std::string> faces; ///< points on the part
    HoleArguments holes;
    double brush = 10.0;                 ///< mm, diameter
    std::optional<std::int64_t> instead; ///< id of the pass that it replaces
    bool preview = false;                ///< nothing is saved
    double directionDegrees = 0.0;
    std::optional<double> flattestDegrees, steepestDegrees;
    PassRequest request;
};

/// Declares --pass and the options that belong to it. @param arguments outlives the parsing
/// @return --pass itself
Argument addPass(CommandParser command, PassArguments& arguments);

/// The request described by the arguments. @param part in the setup frame
/// Errors: those of readDrawing, linesOfTake, faceArea, addHoles and validate; argumentInvalid.
Result<PassRequest> requestOf(const PassArguments& arguments, const Project& project, const Model& part,
                              CommandContext& context);

} // namespace burin
