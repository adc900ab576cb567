// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/commands/take_command.h"

namespace burin {

CommandParser addTakeCommand(CommandParser take, const char* name, TextId help, std::string& project,
                             std::int64_t& number) {
    const CommandParser command = take.command(name, help);
    command.passOn();
    command.positional(BURIN_TEXT("Argument", "PROJECT"), project, BURIN_TEXT("Help", "Project file (.burin)"))
        .required();
    command
        .positional(BURIN_TEXT("Argument", "TAKE"), number, BURIN_TEXT("Help", "Take, by its number in \"burin info\""))
        .required();
    return command;
}

} // namespace burin
