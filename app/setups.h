// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"
#include "app/placing_arguments.h"
#include "core/document/project.h"
#include "core/job/further_setup.h"

#include <optional>
#include <string>

namespace burin {

/// What the command line says of a project's setups, as it was written.
struct SetupsArguments {
    std::optional<std::string> add, name;
    std::string after, remove;
    std::string part; ///< file of the part as it is now
    bool newStock = false, takeStock = false;
    PlacingArguments placing;

    bool changes() const { return add || name || !remove.empty() || takeStock || !placing.empty() || !part.empty(); }
};

/// Declares --add-setup, --after, --new-stock, --update-stock, --update-part, --name, --delete-setup, --align, --turn
/// and
/// --move.
void addSetups(CommandParser command, SetupsArguments& arguments);

/// How the stock that an earlier setup leaves was taken, where one was.
using TakenStock = std::optional<AddedSetup>;

/// Updates the part, then deletes, adds, places, updates and names setups, in this order. The one that was added is
/// used then; else the one in use is meant. Errors: those of addFurtherSetup, takeStockAnew, placingOf and Project.
Result<TakenStock> changeSetups(Project& project, const SetupsArguments& arguments, CommandContext& context);

/// Says in a message how the stock was taken, for after it was saved: a command that fails says its one sentence only.
void tellStock(const TakenStock& stock, CommandContext& context);

/// Each setup with its number, how its part lies and where its stock comes from. Errors: fileDamaged.
Result<nlohmann::json> jsonOfSetups(const Project& project);
/// The same for people, a line each; empty where there is one whose part lies as it came.
Result<std::string> textOfSetups(const Project& project);

} // namespace burin
