// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command_line.h"
#include "core/cad/model.h"
#include "core/passes/pass_request.h"

#include <string>
#include <vector>

namespace burin {

/// The arguments for passes in holes, as given by the user, except for those that are values of the request.
struct HoleArguments {
    std::vector<std::string> holes; ///< points in plan, or numbers of holes
    std::vector<std::string> studs; ///< the same of studs
    std::string thread;             ///< designation
    double threadsPerInch = 0.0;    ///< 0: not given
};

/// Declares --hole, --stud and the options of threads. @param pass the option --pass, which they need
/// @param arguments, request outlive the parsing
void addHoleOptions(CommandParser command, const Argument& pass, HoleArguments& arguments, PassRequest& request);

/// Adds the holes or studs and the thread to a request. @param part in the setup frame
/// Errors: argumentInvalid, those of threadSizeNamed.
Result<void> addHoles(const HoleArguments& arguments, const Model& part, PassRequest& request);

} // namespace burin
