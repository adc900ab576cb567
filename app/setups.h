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

/// The arguments for the setups of a project, as given by the user.
struct SetupsArguments {
    std::optional<std::string> add, name;
    std::string after, remove;
    std::string part; ///< file of the current version of the part; empty: the file that it came from
    std::string unit; ///< of that file; empty: as before
    bool newStock = false, takeStock = false;
    PlacingArguments placing;

    bool readsPart() const { return !part.empty() || !unit.empty(); }
    bool changes() const { return add || name || !remove.empty() || takeStock || !placing.empty() || readsPart(); }
};

/// Declares --add-setup, --after, --new-stock, --update-stock, --update-part, --unit, --name, --delete-setup, --align,
/// --turn and --move.
void addSetups(CommandParser command, SetupsArguments& arguments);

/// How the stock left by an earlier setup was taken over; empty if none was.
using TakenStock = std::optional<AddedSetup>;

/// Updates the part, then deletes, adds, places, updates and names setups, in this order. If a setup was added, the
/// following steps apply to it; otherwise to the setup in use. Errors: those of addFurtherSetup, takeStockAnew,
/// placingOf and Project.
Result<TakenStock> changeSetups(Project& project, const SetupsArguments& arguments, CommandContext& context);

/// Reports how the stock was taken over. Call it after saving: a command that fails prints only its one sentence.
void tellStock(const TakenStock& stock, CommandContext& context);

/// Each setup with its number, the placement of its part and the origin of its stock. Errors: fileDamaged.
Result<nlohmann::json> jsonOfSetups(const Project& project);
/// The same as readable text, one line each; empty if there is only one, whose part was not moved.
Result<std::string> textOfSetups(const Project& project);

} // namespace burin
