// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/sheet_content.h"
#include "core/job/job_paths.h"

#include "core/job/kept_program.h"
#include "core/job/setup_title.h"
#include "core/machine/machine_library.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

namespace burin {

namespace {

/// Returns the tools that a program calls, in the order of their numbers.
std::vector<Tool> calledBy(const CheckedProgram& program) {
    std::set<int> numbers;
    for (const NcMotion& motion : program.parsed.motions) numbers.insert(motion.tool);
    std::vector<Tool> called;
    for (const Tool& tool : program.tools)
        if (program.tools.size() == 1 || numbers.contains(tool.number)) called.push_back(tool);
    std::ranges::sort(called, {}, &Tool::number);
    return called;
}

Result<std::vector<Tool>> milledWith(const Project& project) {
    const Result<std::vector<SourceInfo>> sources = sourcesOf(project);
    if (!sources) return sources.error();
    std::vector<Tool> tools;
    for (const std::string& id : toolsOf(*sources)) {
        Result<Tool> tool = toolFor(project, id);
        if (!tool) return std::move(tool).error();
        tools.push_back(std::move(*tool));
    }
    return tools;
}

Result<void> addProgram(const Project& project, SheetSource& source) {
    const Result<std::optional<ReopenedProgram>> kept = reopenProgram(project);
    if (!kept) return kept.error();
    if (*kept) {
        source.program = (*kept)->program;
        source.programUpToDate = (*kept)->upToDate;
        source.dialect = (*kept)->kept.dialect;
        source.units = (*kept)->kept.units;
        source.tools = calledBy(*source.program);
        const Result<std::vector<StoredProgram>> exported = project.programs();
        if (!exported) return exported.error();
        const auto same = [&](const StoredProgram& program) { return program.text == source.program->text; };
        const auto found = std::find_if(exported->rbegin(), exported->rend(), same);
        if (found != exported->rend()) source.programName = found->name;
        return {};
    }
    Result<std::vector<Tool>> tools = milledWith(project);
    if (!tools) return std::move(tools).error();
    source.tools = std::move(*tools);
    return {};
}

/// Adds the fixtures and keep-out volumes, and the axis mode of the tool.
Result<void> addSurroundings(const Project& project, SheetSource& source) {
    Result<std::vector<Obstacle>> obstacles = project.obstacles();
    if (!obstacles) return std::move(obstacles).error();
    source.obstacles = std::move(*obstacles);
    Result<std::vector<Obstacle>> bodies = bodyFixtures(*source.model, source.setup);
    if (!bodies) return std::move(bodies).error();
    source.obstacles.insert(source.obstacles.end(), bodies->begin(), bodies->end());
    const Result<AxisMode> axis = project.axisMode();
    if (!axis) return axis.error();
    source.axis = *axis;
    const Result<ProgramTarget> target = project.programTarget();
    if (!target) return target.error();
    Result<MachineProfile> machine = loadMachine(target->machine);
    if (!machine) return std::move(machine).error();
    source.dialect = target->dialectFor(*machine);
    source.units = target->units;
    source.machine = std::move(*machine);
    return {};
}

} // namespace

Result<SheetSource> sheetSource(const Project& project, const std::string& file) {
    SheetSource source;
    source.project = std::filesystem::path(file).filename().string();
    Result<Setup> setup = project.setup();
    if (!setup) return std::move(setup).error();
    source.setup = std::move(*setup);
    Result<std::string> title = setupTitle(project);
    if (!title) return std::move(title).error();
    source.setupName = std::move(*title);
    Result<std::shared_ptr<const Model>> model = project.placedModel();
    if (!model) return std::move(model).error();
    source.model = std::move(*model);
    Result<std::vector<Property>> materials = project.materials();
    if (!materials) return std::move(materials).error();
    source.materials = std::move(*materials);
    if (Result<void> added = addSurroundings(project, source); !added) return std::move(added).error();
    if (Result<void> added = addProgram(project, source); !added) return std::move(added).error();
    return source;
}

Result<SheetContent> sheetContent(SheetSource source, Progress& progress) {
    Result<EmbeddedSetup> embedded = embed(*source.model, source.setup, source.materials, progress);
    if (!embedded) return std::move(embedded).error();
    Result<std::vector<BadFit>> bad = badFits(*source.model, source.setup, source.obstacles, progress);
    if (!bad) return std::move(bad).error();
    return SheetContent{std::move(source), embedded->workpiece.snapshot(), materialAmounts(*embedded), std::move(*bad)};
}

} // namespace burin
