// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/chosen_setup.h"
#include "app/command.h"
#include "app/commands/take_command.h"
#include "app/commands/take_deviation.h"
#include "app/commands/take_score.h"
#include "app/take_moment_argument.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/job/switched_off.h"
#include "core/job/take_moves.h"

#include <algorithm>
#include <optional>

namespace burin {

namespace {

using nlohmann::json;

struct TakeArguments {
    std::string project, name;
    std::int64_t take = 0, before = 0, place = 0; ///< place: from 1; 0: not given
    std::optional<double> from, to;
};

/// Changes one take of a project.
using Change = Result<void> (*)(Project& project, const TakeArguments& arguments);

template <bool off>
Result<void> switchInterval(Project& project, const TakeArguments& arguments) {
    const Result<SampleRange> interval = intervalOf(project, arguments.take, arguments.from, arguments.to);
    if (!interval) return interval.error();
    const Result<SwitchedOff> wanted = withInterval(project, arguments.take, *interval, off);
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
    json intervals = json::array();
    double seconds = 0.0;
    for (const SampleRange& range : *off) {
        intervals.push_back({{"first_sample", range.first}, {"samples", range.count}});
        seconds += static_cast<double>(range.count) * take->info.tickPeriod;
    }
    context.answer({{"take", arguments.take}, {"name", take->info.name}, {"switched_off", intervals}},
                   worded(BURIN_TEXT("Command", "take %1 %2: %3 s switched off"),
                          {std::to_string(arguments.take), take->info.name, formatFixed(seconds, 3)}));
    return 0;
}

/// Returns the ids of the takes of a setup in their order.
Result<std::vector<std::int64_t>> takesInOrder(const Project& project, SetupId setup) {
    const Result<std::vector<TakeInfo>> takes = project.takes(setup);
    if (!takes) return takes.error();
    std::vector<std::int64_t> ids;
    for (const TakeInfo& take : *takes) ids.push_back(take.id);
    return ids;
}

/// Saves the project and answers with a take and the order of the takes of its setup.
int saveAndList(ProjectChange& project, std::int64_t id, const std::string& text, const json& more,
                CommandContext& context) {
    const Result<TakeOutline> take = project->takeOutline(id);
    if (!take) return context.fail(take.error());
    const Result<std::vector<std::int64_t>> order = takesInOrder(*project, take->info.setup);
    if (!order) return context.fail(order.error());
    context.stage(BURIN_TEXT("Command", "Saving"));
    if (const Result<void> saved = project.save(); !saved) return context.fail(saved.error());
    tellKeptEarlier(context, *project);
    json answer{{"take", id}, {"name", take->info.name}, {"takes", *order}};
    answer.update(more);
    std::string ids;
    for (const std::int64_t each : *order) ids += (ids.empty() ? "" : ", ") + std::to_string(each);
    context.answer(answer, text + worded(BURIN_TEXT("Command", "order of the takes: %1"), {ids}));
    return 0;
}

Result<TakeOrder> wantedOrder(const Project& project, const TakeArguments& arguments) {
    if (arguments.before != 0) return orderWithTakeBefore(project, arguments.take, arguments.before);
    if (arguments.place < 1)
        return Error{ErrorCode::argumentInvalid, "--to", std::to_string(arguments.place),
                     worded(BURIN_TEXT("Command", "a position from 1, or --before TAKE"))};
    return orderWithTakeAt(project, arguments.take, static_cast<std::size_t>(arguments.place - 1));
}

int runMove(const TakeArguments& arguments, CommandContext& context) {
    Result<ProjectChange> project = projectToChange(arguments.project, context);
    if (!project) return context.fail(project.error());
    const Result<TakeOrder> order = wantedOrder(**project, arguments);
    if (!order) return context.fail(order.error());
    const Result<TakeOutline> take = (*project)->takeOutline(arguments.take);
    if (!take) return context.fail(take.error());
    if (const Result<void> stored = (*project)->setTakeOrder(*order, take->info.setup); !stored)
        return context.fail(stored.error());
    return saveAndList(*project, arguments.take, {}, json::object(), context);
}

int runDuplicate(const TakeArguments& arguments, CommandContext& context) {
    Result<ProjectChange> project = projectToChange(arguments.project, context);
    if (!project) return context.fail(project.error());
    const Result<std::int64_t> copy = (*project)->duplicateTake(arguments.take);
    if (!copy) return context.fail(copy.error());
    return saveAndList(*project, *copy,
                       worded(BURIN_TEXT("Command", "take %1 is a copy of take %2"),
                              {std::to_string(*copy), std::to_string(arguments.take)}) +
                           "\n",
                       {{"copy_of", arguments.take}}, context);
}

/// A command on a take. Returns the exit status.
using TakeAction = std::function<int(const TakeArguments& arguments, CommandContext& context)>;

/// Declares one such command.
CommandParser addAction(CommandParser command, const char* name, TextId help, const TakeAction& action,
                        CommandContext& context, int& status, const std::shared_ptr<TakeArguments>& arguments) {
    const CommandParser one = addTakeCommand(command, name, help, arguments->project, arguments->take);
    one.run([arguments, action, &context, &status] { status = action(*arguments, context); });
    return one;
}

TakeAction changing(Change change) {
    return [change](const TakeArguments& arguments, CommandContext& context) {
        return runChange(arguments, change, context);
    };
}

} // namespace

void registerTake(CommandParser program, CommandContext& context, int& status) {
    const CommandParser command = program.command(
        "take",
        BURIN_TEXT("Help", "Switch takes, or parts of them, off and on; rename, move, copy, score and measure them"));
    command.requireCommand();
    addSetupChoice(command, context);
    addJsonFlag(command, context);
    auto arguments = std::make_shared<TakeArguments>();
    const CommandParser off = addAction(
        command, "off",
        BURIN_TEXT("Help", "Workpiece and paths are made without it, until it is switched on again; nothing is erased"),
        changing(&switchInterval<true>), context, status, arguments);
    const CommandParser on = addAction(command, "on", BURIN_TEXT("Help", "It counts again"),
                                       changing(&switchInterval<false>), context, status, arguments);
    for (const CommandParser& one : {off, on}) {
        one.option("--from", arguments->from,
                   BURIN_TEXT("Help", "Beginning of the part, s from the start of the take (default: its start)"));
        one.option("--to", arguments->to,
                   BURIN_TEXT("Help", "End of the part, s from the start of the take (default: its end)"));
    }
    addAction(command, "rename", BURIN_TEXT("Help", "Rename it"), changing(&rename), context, status, arguments)
        .positional(BURIN_TEXT("Argument", "NAME"), arguments->name, BURIN_TEXT("Help", "Its new name"))
        .required();
    addTakeScore(command, context, status);
    addTakeDeviation(command, context, status);
    const CommandParser move = addAction(
        command, "move",
        BURIN_TEXT("Help", "Replay it earlier or later among the takes of its setup; the workpiece at the end "
                           "and the paths stay"),
        &runMove, context, status, arguments);
    const Argument before =
        move.option("--before", arguments->before, BURIN_TEXT("Help", "Just before this take, by its number"));
    move.option("--to", arguments->place, BURIN_TEXT("Help", "To this position in the order of the takes, from 1"))
        .excludes(before);
    addAction(command, "duplicate",
              BURIN_TEXT("Help",
                         "Copy it with its strokes and what is switched off, after all other takes; no path mills "
                         "the copy until \"burin path P apply PATH --take\" adds it"),
              &runDuplicate, context, status, arguments);
}

} // namespace burin
