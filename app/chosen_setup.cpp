// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/chosen_setup.h"

#include "app/wording.h"

#include <algorithm>
#include <utility>

namespace burin {

namespace {

Result<void> use(Project& project, const CommandContext& context) {
    if (context.setup.empty()) return {};
    const Result<SetupId> id = setupNamed(project, context.setup);
    return id ? project.useSetup(*id) : Result<void>(id.error());
}

} // namespace

void addSetupChoice(CommandParser command, CommandContext& context) {
    command.option("--setup", context.setup,
                   BURIN_TEXT("Help", "Number or name of the setup to work in (default: the first)"));
}

std::string textOf(const SetupName& setup) {
    return setup.name.empty() ? worded(BURIN_TEXT("Command", "setup %1"), {std::to_string(numberOf(setup.id))})
                              : setup.name;
}

Result<SetupId> setupNamed(const Project& project, const std::string& text) {
    const Result<std::vector<SetupName>> setups = project.setups();
    if (!setups) return setups.error();
    const auto isNumber = [&](const SetupName& setup) { return std::to_string(numberOf(setup.id)) == text; };
    if (const auto found = std::ranges::find_if(*setups, isNumber); found != setups->end()) return found->id;
    const auto found = std::ranges::find(*setups, text, &SetupName::name);
    if (std::ranges::count(*setups, text, &SetupName::name) == 1 && !text.empty()) return found->id;
    if (found != setups->end())
        return Error{ErrorCode::argumentInvalid, "--setup", text,
                     worded(BURIN_TEXT("Command", "the number of a setup"))};
    std::string known;
    for (const SetupName& setup : *setups) {
        known += (known.empty() ? "" : ", ") + std::to_string(numberOf(setup.id));
        if (!setup.name.empty()) known += " (" + setup.name + ")";
    }
    return Error{ErrorCode::nameUnknown, "setup", text, known};
}

Result<Project> projectForReading(const std::string& file, const CommandContext& context) {
    Result<Project> project = Project::openForReading(file);
    if (!project) return project;
    if (Result<void> used = use(*project, context); !used) return std::move(used).error();
    return project;
}

Result<Project> projectToMill(const std::string& file, const CommandContext& context) {
    Result<Project> project = Project::open(file);
    if (!project) return project;
    if (Result<void> used = use(*project, context); !used) return std::move(used).error();
    return project;
}

Result<ProjectChange> projectToChange(const std::string& file, const CommandContext& context) {
    Result<ProjectChange> project = ProjectChange::open(file);
    if (!project) return project;
    if (Result<void> used = use(**project, context); !used) return std::move(used).error();
    return project;
}

} // namespace burin
