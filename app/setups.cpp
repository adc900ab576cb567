// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/setups.h"

#include "app/chosen_setup.h"
#include "app/unit_argument.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/base/steps.h"
#include "core/cad/file_unit.h"
#include "core/job/job_paths.h"
#include "core/job/left_stock.h"
#include "core/job/part_update.h"

#include <algorithm>
#include <utility>

namespace burin {

namespace {

Result<TakenStock> add(Project& project, const SetupsArguments& arguments, CommandContext& context) {
    FurtherSetup further;
    further.name = *arguments.add;
    further.leftStock = !arguments.newStock;
    if (!arguments.after.empty()) {
        const Result<SetupId> after = setupNamed(project, arguments.after);
        if (!after) return after.error();
        further.after = *after;
    }
    Result<std::shared_ptr<const Model>> part = project.placedModel(further.after);
    if (!part) return std::move(part).error();
    const Result<Placement> turn = placingOf(arguments.placing, std::move(*part), context.progress());
    if (!turn) return turn.error();
    further.turn = *turn;
    context.stage(BURIN_TEXT("Command", "Preparing the stock"));
    const Result<AddedSetup> added = addFurtherSetup(project, further, context.progress());
    if (!added) return added.error();
    if (Result<void> used = project.useSetup(added->id); !used) return std::move(used).error();
    return further.leftStock ? TakenStock(*added) : std::nullopt;
}

/// Reads the part again, and reports what happened to its bodies.
Result<void> updatePart(Project& project, const SetupsArguments& arguments, CommandContext& context) {
    context.stage(BURIN_TEXT("Command", "Importing"));
    const Result<Model> before = project.model();
    if (!before) return before.error();
    ImportOptions options = importOptionsAsBefore(*before);
    if (Result<void> applied = applyUnit(arguments.unit, options); !applied) return applied;
    const std::string& file = arguments.part.empty() ? before->sourceFile : arguments.part;
    const Result<Model> model = importModel(file, options, context.progress());
    if (!model) return model.error();
    const Result<PartUpdate> update = burin::updatePart(project, *model);
    if (!update) return update.error();
    const auto tell = [&context](TextId what, const std::vector<std::string>& names) {
        if (!names.empty()) context.message(worded(what, {listed(names)}));
    };
    tell(BURIN_TEXT("Command", "changed bodies: %1"), update->changed);
    tell(BURIN_TEXT("Command", "new bodies: %1"), update->added);
    tell(BURIN_TEXT("Command", "removed bodies: %1"), update->removed);
    if (update->nothing()) context.message(worded(BURIN_TEXT("Command", "the part has not changed")));
    if (update->stockStays)
        context.message(
            worded(BURIN_TEXT("Command", "stock and program zero stay where they are, as there are recordings "
                                         "or passes; check the programs again")));
    return {};
}

/// Requires a setup without recordings and passes: they refer to the present placement of the part.
Result<void> requireUntouched(const Project& project) {
    const Result<std::vector<SourceInfo>> sources = sourcesOf(project);
    if (!sources) return sources.error();
    if (sources->empty()) return {};
    return Error{ErrorCode::argumentInvalid, "setup",
                 worded(BURIN_TEXT("Command", "%1 recordings and passes"), {std::to_string(sources->size())}),
                 worded(BURIN_TEXT("Command", "a setup without recordings and passes, or --add-setup"))};
}

Result<void> place(Project& project, const SetupsArguments& arguments, CommandContext& context) {
    if (Result<void> untouched = requireUntouched(project); !untouched) return untouched;
    Result<std::shared_ptr<const Model>> part = project.placedModel();
    if (!part) return std::move(part).error();
    const Result<Placement> by = placingOf(arguments.placing, *part, context.progress());
    if (!by) return by.error();
    Result<Setup> setup = project.setup();
    if (!setup) return std::move(setup).error();
    Result<Setup> further = placedFurther(std::move(*setup), *by, context.progress());
    if (!further) return std::move(further).error();
    const Result<Setup> complete = placeStock(*placed(*part, *by), std::move(*further));
    return complete ? project.setSetup(*complete) : Result<void>(complete.error());
}

Result<TakenStock> takeStock(Project& project, CommandContext& context) {
    context.stage(BURIN_TEXT("Command", "Preparing the stock"));
    const Result<AddedSetup> taken = takeStockAnew(project, setupInUse, context.progress());
    return taken ? Result<TakenStock>(*taken) : taken.error();
}

/// The placement and origin of a setup; empty if nothing is embedded in it yet.
Result<std::optional<Setup>> contentOf(const Project& project, SetupId id) {
    Result<Setup> setup = project.setup(id);
    if (setup) return std::optional(std::move(*setup));
    if (setup.error().code == ErrorCode::projectIncomplete) return std::optional<Setup>();
    return std::move(setup).error();
}

} // namespace

void addSetups(CommandParser command, SetupsArguments& arguments) {
    addPlacing(command, arguments.placing);
    command.option("--add-setup", arguments.add,
                   BURIN_TEXT("Help", "Add a setup of this name. --align, --turn and --move place the part in it, "
                                      "relative to the setup before; its stock is the workpiece of that setup"));
    command.option("--after", arguments.after,
                   BURIN_TEXT("Help", "Number or name of the setup that precedes the new one (default: --setup)"));
    command.flag("--new-stock", arguments.newStock,
                 BURIN_TEXT("Help", "Give the new setup a new stock with the same margins"));
    command.flag("--update-stock", arguments.takeStock,
                 BURIN_TEXT("Help", "Update the stock from the setup that it comes from"));
    command.option("--update-part", arguments.part,
                   BURIN_TEXT("Help", "Read the part again from this file: roles and materials of bodies stay by their "
                                      "names, and so do setups, recordings and paths"));
    addUnit(command, arguments.unit);
    command.option("--name", arguments.name, BURIN_TEXT("Help", "Name of the setup"));
    command.option(
        "--delete-setup", arguments.remove,
        BURIN_TEXT("Help", "Number or name of a setup to delete; only one without recordings, paths and programs"));
}

Result<TakenStock> changeSetups(Project& project, const SetupsArguments& arguments, CommandContext& context) {
    TakenStock left;
    const auto keep = [&left](const Result<TakenStock>& stock) {
        if (!stock) return Result<void>(stock.error());
        left = *stock;
        return Result<void>();
    };
    const auto remove = [&] {
        const Result<SetupId> id = setupNamed(project, arguments.remove);
        return id ? project.removeSetup(*id) : Result<void>(id.error());
    };
    const bool places = !arguments.add && !arguments.placing.empty();
    const Result<void> done =
        inOrder([&] { return arguments.readsPart() ? updatePart(project, arguments, context) : Result<void>(); },
                [&] { return arguments.remove.empty() ? Result<void>() : remove(); },
                [&] { return arguments.add ? keep(add(project, arguments, context)) : Result<void>(); },
                [&] { return places ? place(project, arguments, context) : Result<void>(); },
                [&] { return arguments.takeStock ? keep(takeStock(project, context)) : Result<void>(); },
                [&] { return arguments.name ? project.nameSetup(setupInUse, *arguments.name) : Result<void>(); });
    return done ? Result<TakenStock>(std::move(left)) : done.error();
}

void tellStock(const TakenStock& stock, CommandContext& context) {
    if (!stock) return;
    context.message(stock->byProgram
                        ? worded(BURIN_TEXT("Command", "its stock is the workpiece after the checked program"))
                        : worded(BURIN_TEXT("Command", "its stock is the workpiece after the recordings, because there "
                                                       "is no checked program that is up to date")));
    if (stock->greatestDisplacement > 0.0)
        context.message(worded(
            BURIN_TEXT("Command",
                       "the rotation is not a multiple of 90 degrees: faces of the stock may be off by up to %1 mm"),
            {formatFixed(stock->greatestDisplacement, 3)}));
}

Result<nlohmann::json> jsonOfSetups(const Project& project) {
    const Result<std::vector<SetupName>> setups = project.setups();
    if (!setups) return setups.error();
    nlohmann::json list = nlohmann::json::array();
    for (const SetupName& name : *setups) {
        nlohmann::json record{
            {"id", numberOf(name.id)}, {"name", name.name}, {"in_use", name.id == project.usedSetup()}};
        const Result<std::optional<Setup>> setup = contentOf(project, name.id);
        if (!setup) return setup.error();
        if (*setup) {
            const Result<bool> outOfDate = isStockOutOfDate(project, name.id);
            if (!outOfDate) return outOfDate.error();
            record["placement"] = jsonOf((*setup)->placement);
            record["stock_left_by"] =
                (*setup)->leftBy ? nlohmann::json(numberOf((*setup)->leftBy->setup)) : nlohmann::json();
            record["stock_out_of_date"] = *outOfDate;
        }
        list.push_back(std::move(record));
    }
    return list;
}

Result<std::string> textOfSetups(const Project& project) {
    const Result<std::vector<SetupName>> setups = project.setups();
    if (!setups) return setups.error();
    std::string text;
    for (const SetupName& name : *setups) {
        const Result<std::optional<Setup>> setup = contentOf(project, name.id);
        if (!setup) return setup.error();
        std::string line =
            worded(BURIN_TEXT("Command", "setup    %1 %2"), {std::to_string(numberOf(name.id)), name.name});
        const std::string lies = *setup ? textOf((*setup)->placement) : std::string();
        if (!lies.empty()) line += ", " + lies;
        if (*setup && (*setup)->leftBy) {
            const Result<bool> outOfDate = isStockOutOfDate(project, name.id);
            if (!outOfDate) return outOfDate.error();
            line +=
                "; " + worded(*outOfDate ? BURIN_TEXT("Command", "its stock is the workpiece of setup %1, which has "
                                                                 "changed since (update it with --update-stock)")
                                         : BURIN_TEXT("Command", "its stock is the workpiece of setup %1"),
                              {std::to_string(numberOf((*setup)->leftBy->setup))});
        }
        if (name.id == project.usedSetup() && setups->size() > 1) line += " *";
        text += "\n" + line;
    }
    const bool plain = setups->size() == 1 && text.find(',') == std::string::npos && setups->front().name.empty();
    return plain ? std::string() : text;
}

} // namespace burin
