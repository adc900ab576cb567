// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/chosen_setup.h"
#include "app/command.h"
#include "app/take_moment_argument.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/job/switched_off.h"

#include <optional>

namespace burin {

namespace {

using nlohmann::json;

struct TakeArguments {
    std::string project, name;
    std::int64_t take = 0;
    std::optional<double> from, to;
};

/// Changes one take of a project.
using Change = Result<void> (*)(Project& project, const TakeArguments& arguments);

template <bool off>
Result<void> switchStretch(Project& project, const TakeArguments& arguments) {
    const Result<SampleRange> stretch = stretchOf(project, arguments.take, arguments.from, arguments.to);
    if (!stretch) return stretch.error();
    const Result<SwitchedOff> wanted = withStretch(project, arguments.take, *stretch, off);
    if (!wanted) return wanted.error();
    return setSwitchedOff(project, *wanted);
}

Result<void> rename(Project& project, const TakeArguments& arguments) {
    if (arguments.name.find_first_not_of(" \t") == std::string::npos)
        return Error{ErrorCode::argumentInvalid, "name", arguments.name, "a name"};
    return project.nameTake(arguments.take, arguments.name);
}

int runChange(const TakeArguments& arguments, Change change, CommandContext& context) {
    Result<ProjectChange> project = projectToChange(arguments.project, context);
    if (!project) return context.fail(project.error());
    if (const Result<void> done = change(**project, arguments); !done) return context.fail(done.error());
    const Result<TakeOutline> take = (*project)->takeOutline(arguments.take);
    if (!take) return context.fail(take.error());
    const Result<std::vector<SampleRange>> off = (*project)->switchedOff(arguments.take);
    if (!off) return context.fail(off.error());
    context.stage(BURIN_TEXT("Command", "Saving"));
    if (const Result<void> saved = project->save(); !saved) return context.fail(saved.error());
    tellKeptEarlier(context, **project);
    json stretches = json::array();
    double seconds = 0.0;
    for (const SampleRange& range : *off) {
        stretches.push_back({{"first_sample", range.first}, {"samples", range.count}});
        seconds += static_cast<double>(range.count) * take->info.tickPeriod;
    }
    context.answer({{"take", arguments.take}, {"name", take->info.name}, {"switched_off", stretches}},
                   worded(BURIN_TEXT("Command", "take %1 %2: %3 s switched off"),
                          {std::to_string(arguments.take), take->info.name, formatFixed(seconds, 3)}));
    return 0;
}

/// Declares one such command.
CommandParser addChange(CommandParser command, const char* name, TextId help, Change change, CommandContext& context,
                        int& status, const std::shared_ptr<TakeArguments>& arguments) {
    const CommandParser one = command.command(name, help);
    one.passOn();
    one.positional(BURIN_TEXT("Argument", "PROJECT"), arguments->project, BURIN_TEXT("Help", "Project file (.burin)"))
        .required();
    one.positional(BURIN_TEXT("Argument", "TAKE"), arguments->take,
                   BURIN_TEXT("Help", "Take, by its number in \"burin info\""))
        .required();
    one.run([arguments, change, &context, &status] { status = runChange(*arguments, change, context); });
    return one;
}

} // namespace

void registerTake(CommandParser program, CommandContext& context, int& status) {
    const CommandParser command =
        program.command("take", BURIN_TEXT("Help", "Switch takes, or parts of them, off and on; rename them"));
    command.requireCommand();
    addSetupChoice(command, context);
    addJsonFlag(command, context);
    auto arguments = std::make_shared<TakeArguments>();
    const CommandParser off = addChange(
        command, "off",
        BURIN_TEXT("Help", "Workpiece and paths are made without it, until it is switched on again; nothing is erased"),
        &switchStretch<true>, context, status, arguments);
    const CommandParser on = addChange(command, "on", BURIN_TEXT("Help", "It counts again"), &switchStretch<false>,
                                       context, status, arguments);
    for (const CommandParser& one : {off, on}) {
        one.option("--from", arguments->from,
                   BURIN_TEXT("Help", "Beginning of the part, s from the start of the take (default: its start)"));
        one.option("--to", arguments->to,
                   BURIN_TEXT("Help", "End of the part, s from the start of the take (default: its end)"));
    }
    addChange(command, "rename", BURIN_TEXT("Help", "Rename it"), &rename, context, status, arguments)
        .positional(BURIN_TEXT("Argument", "NAME"), arguments->name, BURIN_TEXT("Help", "Its new name"))
        .required();
}

} // namespace burin
