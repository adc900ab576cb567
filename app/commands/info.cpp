// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/report.h"
#include "app/surroundings.h"
#include "core/base/numbers.h"
#include "core/job/kept_program.h"

#include <CLI/CLI.hpp>

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
            {"tick_period_s", take.tickPeriod},
            {"duration_s", take.seconds ? json(*take.seconds) : json(nullptr)},
            {"started_unix_s", take.startedUnixTime},
            {"stylus", take.stylus},
            {"complete", take.complete}};
}

/// "passed" is said only where all that the check judged is as it was then.
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
    if (!kept.upToDate) return "out of date: inputs of the program's check have changed; post it again";
    const std::size_t errors = kept.program->errorCount();
    return std::string(stateOf(kept)) + ": gouge " + formatFixed(kept.program->report.gougeMax, 4) + " mm (tolerance " +
           formatFixed(kept.kept.gougeTolerance, 3) + " mm), " + std::to_string(errors) +
           (errors == 1 ? " error" : " errors");
}

/// What a project lacks is null, so that a half-done project can be looked at too.
int runInfo(const std::string& file, CommandContext& context) {
    context.stage("Opening");
    const Result<Project> project = Project::openForReading(file);
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
    const Result<KeptGuides> guides = project->guides();
    if (!guides) return context.fail(guides.error());
    const Result<std::optional<ReopenedProgram>> kept = reopenProgram(*project);
    if (!kept) return context.fail(kept.error());

    json answer{{"project", std::filesystem::absolute(file).lexically_normal().string()},
                {"recovered", project->recovered()},
                {"model", model ? burin::jsonOf(*model) : json(nullptr)},
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
                                    {"work_offset_mm", burin::jsonOf(setup->workOffset)}};
    std::uint64_t samples = 0;
    std::ostringstream text;
    text << file << (project->recovered() ? " (recovered from a run that was interrupted)" : "");
    if (model) text << "\n" << textOf(*model);
    if (setup) text << "\n  stock    " << setup->stockMaterial << ", voxel " << formatShortest(setup->voxel) << " mm";
    if (setup) text << "\n  axis     " << textOf(around->axis);
    for (const Obstacle& obstacle : around->obstacles) text << "\n  " << textOf(obstacle);
    for (const TakeInfo& take : *takes) {
        samples += take.sampleCount;
        answer["takes"].push_back(jsonOf(take));
        text << "\n  take     " << take.id << " " << take.name << ": " << take.sampleCount << " samples, "
             << (take.seconds ? formatFixed(*take.seconds, 3) + " s" : "damaged") << ", tool " << take.toolId
             << (take.complete ? "" : ", incomplete");
    }
    answer["samples"] = samples;
    for (const StoredPath& path : *paths) {
        json edits = json::array();
        for (const Edit& edit : path.edits) edits.push_back(json::parse(toJson(edit)));
        answer["paths"].push_back({{"id", path.id}, {"name", path.name}, {"takes", path.takes}, {"edits", edits}});
        text << "\n  path     " << path.id << " " << path.name << ": " << path.takes.size() << " takes, "
             << path.edits.size() << " edits";
    }
    for (const StoredProgram& program : *programs) {
        answer["programs"].push_back(
            {{"name", program.name}, {"dialect", program.dialect}, {"machine", program.machine}});
        text << "\n  program  " << program.name << " (" << program.dialect << ", " << program.machine << ")";
    }
    answer["verdict"] = *kept ? verdictOf(**kept) : json(nullptr);
    if (*kept) text << "\n  verdict  " << verdictText(**kept);
    context.answer(answer, text.str());
    return 0;
}

} // namespace

void registerInfo(CLI::App& program, CommandContext& context, int& status) {
    auto file = std::make_shared<std::string>();
    CLI::App* command = program.add_subcommand("info", "Report what a project holds");
    command->add_option("PROJECT", *file, "Project file (.burin)")->required();
    addJsonFlag(*command, context);
    command->callback([file, &context, &status] { status = runInfo(*file, context); });
}

} // namespace burin
