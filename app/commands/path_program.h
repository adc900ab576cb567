// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"
#include "core/document/project_change.h"

#include <string>

namespace burin {

/// The arguments for converting a program to paths, as given by the user.
struct ProgramPathArguments {
    std::string file, tool, dialect, name;
};

/// Makes one path per tool from the moves of a program, saves and answers.
/// @param machine id; empty: that of the project @return exit status
int addProgramPaths(ProjectChange& project, const ProgramPathArguments& arguments, const std::string& machine,
                    CommandContext& context);

} // namespace burin
