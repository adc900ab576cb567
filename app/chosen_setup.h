// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"
#include "core/document/project_change.h"

#include <string>

namespace burin {

/// Declares --setup: which setup of a project a command works in.
void addSetupChoice(CommandParser command, CommandContext& context);

/// A setup by its number or its name. Errors: nameUnknown, argumentInvalid (a name that several have).
Result<SetupId> setupNamed(const Project& project, const std::string& text);
/// Its name; "setup 2" where it has none.
std::string textOf(const SetupName& setup);

// Projects in the setup that --setup asked for, or in their first one. Errors: as the function of Project or
// ProjectChange, and those of setupNamed.
Result<Project> projectForReading(const std::string& file, const CommandContext& context);
Result<Project> projectToMill(const std::string& file, const CommandContext& context);
Result<ProjectChange> projectToChange(const std::string& file, const CommandContext& context);

} // namespace burin
