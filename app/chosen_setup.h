// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"
#include "core/document/project_change.h"

#include <string>

namespace burin {

/// Declares --setup, which selects the setup of a project that a command works in.
void addSetupChoice(CommandParser command, CommandContext& context);

/// Finds a setup by its number or its name. Errors: nameUnknown, argumentInvalid (several setups have the name).
Result<SetupId> setupNamed(const Project& project, const std::string& text);
/// The name of a setup; "setup 2" if it has none.
std::string textOf(const SetupName& setup);

// Open a project in the setup selected by --setup, or in its first one. Errors: those of the corresponding function of
// Project or ProjectChange, and of setupNamed.
Result<Project> projectForReading(const std::string& file, const CommandContext& context);
Result<Project> projectToMill(const std::string& file, const CommandContext& context);
Result<ProjectChange> projectToChange(const std::string& file, const CommandContext& context);

} // namespace burin
