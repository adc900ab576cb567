// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command_line.h"

#include <memory>
#include <string>

namespace burin {

class CommandContext;

/// The arguments of a command for a library of the user's own files.
struct LibraryArguments {
    std::string id, file, newId, name;
    std::string library; ///< of tools; empty: not stated
    bool replace = false;
};

/// A command with list, show, add, copy and remove: its texts and its functions.
struct LibraryCommand {
    using Run = int (*)(const LibraryArguments&, CommandContext&);

    const char* name; ///< "machines"
    TextId about, list, show, add, addedFile, copy, copied, remove, replace;
    TextId item; ///< what an id identifies, in the help of its argument
    Run runList, runShow, runAdd, runCopy, runRemove;
};

/// @param arguments shared with options and subcommands that are added
/// @return the command, to which they may be added
CommandParser registerLibrary(CommandParser program, CommandContext& context, int& status,
                              const LibraryCommand& library,
                              std::shared_ptr<LibraryArguments> arguments = std::make_shared<LibraryArguments>());

} // namespace burin
