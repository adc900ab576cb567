// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/chosen_setup.h"
#include "app/command.h"
#include "app/hole_report.h"
#include "app/number_list.h"
#include "app/report.h"
#include "app/setups.h"
#include "app/stock_arguments.h"
#include "app/surroundings.h"
#include "app/wording.h"
#include "app/zero_arguments.h"
#include "core/base/numbers.h"
#include "core/cad/part_holes.h"
#include "core/job/kept_program.h"
#include "ui/panels/texts.h"

#include <sstream>

namespace burin {

namespace {

using nlohmann::json;

json jsonOf(const TakeInfo& take) {
    return {{"id", take.id},
            {"name", take.name},
            {"tool", take.toolId},
            {"allowance_mm", take.allowance},
            {"samples", take.sampleCount},
            {"samples_that_count_no_more", take.undoneCount},
            {"tick_period_s", take.tickPeriod},
            {"duration_s", take.seconds ? json(*take.seconds) : json(nullptr)},
            {"started_unix_s", take.startedUnixTime},
            {"stylus", take.stylus},
            {"complete", take.complete},
            {"copy_of", take.copyOf != 0 ? json(take.copyOf) : json(nullptr)}};
}

/// "passed" is reported only if everything that the check depended on is unchanged.
const char* stateOf(const ReopenedProgram& kept) {
    if (!kept.upToDate) return "out_of_date";
    if (kept.program->passed()) return "passed";
    return kept.program->overridden ? "overridden" : "refused";
}

json verdictOf(const ReopenedProgram& kept) {
    return {{"state", stateOf(kept)},
            {"passed", kept.upToDate && kept.program->passed()},
            {"errors", kept.program->errorCount()},
            {"gouge_max_mm", kept.program->report.gougeMax},
            {"gouge_tolerance_mm", kept.kept.gougeTolerance},
            {"dialect", kept.kept.dialect},
            {"machine", kept.kept.machine}};
}

std::string verdictText(const ReopenedProgram& kept) {
    if (!kept.upToDate)
        return worded(
            BURIN_TEXT("Command", "verdict  out of date: inputs of the program's check have changed; post it again"));
    const CheckedProgram& program = *kept.program;
    const TextId state = program.passed()     ? BURIN_TEXT("Command", "passed")
                         : program.overridden ? BURIN_TEXT("Command", "overridden")
                                              : BURIN_TEXT("Command", "refused");
    return worded(program.errorCount(), BURIN_TEXT("Command", "verdict  %2: gouge %3 mm (tolerance %4 mm), %1 error"),
                  BURIN_TEXT("Command", "verdict  %2: gouge %3 mm (tolerance %4 mm), %1 errors"),
                  {worded(state), formatFixed(program.report.gougeMax, 4), formatFixed(kept.kept.gougeTolerance, 3)});
}

std::string textOf(const TakeInfo& take) {
    const std::string length = take.seconds ? worded(BURIN_TEXT("Command", "%1 s"), {formatFixed(*take.seconds, 3)})
                                            : worded(BURIN_TEXT("Command", "damaged"));
    return worded(take.complete ? BURIN_TEXT("Command", "take     %1 %2: %3 samples, %4, tool %5")
                                : BURIN_TEXT("Command", "take     %1 %2: %3 samples, %4, tool %5, incomplete"),
                  {std::to_string(take.id), takeName(take.name).toStdString(), std::to_string(take.sampleCount), length,
                   take.toolId});
}

std::string infoText(const StoredPath& path) {
    return worded(BURIN_TEXT("Command", "path     %1 %2: %3 takes, %4 edits"),
                  {std::to_string(path.id), path.name, std::to_string(takesOf(path.sources).size()),
                   std::to_string(path.edits.size())});
}

/// Missing parts of a project are null, so that an unfinished project can be inspected as well.
int runInfo(const std::string& file, CommandContext& context) {
    context.stage(BURIN_TEXT("Command", "Opening"));
    const Result<Project> project = projectForReading(file, context);
    if (!project) return context.fail(project.error());
    const Result<std::vector<TakeInfo>> takes = project->takes();
    if (!takes) return context.fail(takes.error());
    const Result<std::vector<StoredPath>> paths = project->paths();
    if (!paths) return context.fail(paths.error());
    const Result<std::vector<StoredProgram>> programs = project->programs();
    if (!programs) return context.fail(programs.error());
    const Result<Model> model = project->model();
    if (!model && model.error().code != ErrorCode::projectIncomplete) return context.fail(model.error());
    const Result<Setup> setup = project->setup();
    if (!setup && setup.error().code != ErrorCode::projectIncomplete) return context.fail(setup.error());

    const Result<Around> around = aroundOf(*project);
    if (!around) return context.fail(around.error());
    const Result<json> setups = jsonOfSetups(*project);
    if (!setups) return context.fail(setups.error());
    const Result<std::string> setupsText = textOfSetups(*project);
    if (!setupsText) return context.fail(setupsText.error());
    const Result<KeptGuides> guides = project->guides();
    if (!guides) return context.fail(guides.error());
    const Result<std::optional<ReopenedProgram>> kept = reopenProgram(*project);
    if (!kept) return context.fail(kept.error());

    std::vector<UprightHole> holes, studs;
    if (model && setup) {
        const std::shared_ptr<const Model> part = protectedPart(std::make_shared<const Model>(*model), *setup);
        holes = uprightHoles(*part);
        studs = uprightStuds(*part);
    }

    json answer{{"project", std::filesystem::absolute(file).lexically_normal().string()},
                {"recovered", project->recovered()},
                {"model", model ? burin::jsonOf(*model) : json(nullptr)},
                {"holes", burin::jsonOf(holes)},
                {"studs", burin::jsonOf(studs)},
                {"setups", *setups},
                {"axis", burin::jsonOf(around->axis)},
                {"machine_travel", burin::jsonOf(around->travel)},
                {"obstacles", burin::jsonOf(around->obstacles)},
                {"guides", guides->guides.size()},
                {"takes", json::array()},
                {"paths", json::array()},
                {"programs", json::array()}};
    answer["setup"] = !setup ? json(nullptr)
                             : json{{"stock_box_mm", burin::jsonOf(setup->stock)},
                                    {"voxel_mm", setup->voxel},
                                    {"material", setup->stockMaterial},
                                    {"stock_form", idOf(setup->form)},
                                    {"free_carving", setup->freeCarving},
                                    {"roles", model ? jsonOfRoles(*model, *setup) : json::object()},
                                    {"layers", jsonOfLayers(*setup)},
                                    {"zero", burin::jsonOf(setup->zero)},
                                    {"work_offset_mm", burin::jsonOf(setup->workOffset)}};
    std::uint64_t samples = 0;
    std::ostringstream text;
    text << file
         << (project->recovered() ? " " + worded(BURIN_TEXT("Command", "(recovered from a run that was interrupted)"))
                                  : "");
    if (model) text << "\n" << textOf(*model);
    if (const std::string sizes = textOf(holes); !sizes.empty()) text << "\n  " << sizes;
    if (const std::string sizes = textOfStuds(studs); !sizes.empty()) text << "\n  " << sizes;
    if (setup)
        text << "\n  "
             << worded(BURIN_TEXT("Command", "stock    %1, voxel %2 mm"),
                       {setup->stockMaterial, formatShortest(setup->voxel)})
             << (model ? textOfStock(*model, *setup) : std::string());
    for (const std::string& line : partsOf(*setupsText, '\n'))
        if (!line.empty()) text << "\n  " << line;
    if (setup) text << "\n  " << worded(BURIN_TEXT("Command", "axis     %1"), {textOf(around->axis)});
    for (const Obstacle& obstacle : around->obstacles) text << "\n  " << textOf(obstacle);
    for (const TakeInfo& take : *takes) {
        samples += take.sampleCount;
        answer["takes"].push_back(jsonOf(take));
        text << "\n  " << textOf(take);
    }
    answer["samples"] = samples;
    for (const StoredPath& path : *paths) {
        json edits = json::array();
        for (const Edit& edit : path.edits) edits.push_back(json::parse(toJson(edit)));
        answer["paths"].push_back(
            {{"id", path.id}, {"name", path.name}, {"takes", takesOf(path.sources)}, {"edits", edits}});
        text << "\n  " << infoText(path);
    }
    for (const StoredProgram& program : *programs) {
        answer["programs"].push_back(
            {{"name", program.name}, {"dialect", program.dialect}, {"machine", program.machine}});
        text << "\n  "
             << worded(BURIN_TEXT("Command", "program  %1 (%2, %3)"), {program.name, program.dialect, program.machine});
    }
    answer["verdict"] = *kept ? verdictOf(**kept) : json(nullptr);
    if (*kept) text << "\n  " << verdictText(**kept);
    context.answer(answer, text.str());
    return 0;
}

} // namespace

void registerInfo(CommandParser program, CommandContext& context, int& status) {
    auto file = std::make_shared<std::string>();
    const CommandParser command = program.command("info", BURIN_TEXT("Help", "Report the contents of a project"));
    command.positional(BURIN_TEXT("Argument", "PROJECT"), *file, BURIN_TEXT("Help", "Project file (.burin)"))
        .required();
    addSetupChoice(command, context);
    addJsonFlag(command, context);
    command.run([file, &context, &status] { status = runInfo(*file, context); });
}

} // namespace burin
