// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command_line.h"

#include <cstdint>
#include <string>

namespace burin {

/// Declares a subcommand of `take` for one take of a project: its name, help, and the two arguments that all have.
/// @param project, number outlive the parsing
CommandParser addTakeCommand(CommandParser take, const char* name, TextId help, std::string& project,
                             std::int64_t& number);

} // namespace burin
