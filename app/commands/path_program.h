// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"
#include "core/document/project_change.h"

#include <string>

namespace burin {

/// What the command line says of a program that becomes paths, as it was written.
struct ProgramPathArguments {
    std::string file, tool, dialect, name;
};

/// Makes a path of what a program mills with each tool, saves and answers.
/// @param machine by id; empty: the project's @return exit status
int addProgramPaths(ProjectChange& project, const ProgramPathArguments& arguments, const std::string& machine,
                    CommandContext& context);

} // namespace burin
