// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/commands/path_program.h"

#include "app/path_report.h"
#include "app/surroundings.h"
#include "app/wording.h"
#include "core/base/file.h"
#include "core/base/numbers.h"
#include "core/document/companions.h"
#include "core/job/program_path.h"
#include "core/nc/dialect_library.h"
#include "core/verify/tool_moves.h"

#include <algorithm>

namespace burin {

namespace {

/// What could not be imported unchanged.
std::string textOfLosses(const ProgramPasses& passes) {
    std::string text = "\n" + worded(BURIN_TEXT("Command", "Rapids were left out: links replace them."));
    const auto add = [&text](std::size_t count, TextId one, TextId many) {
        if (count > 0) text += "\n" + worded(count, one, many, {});
    };
    add(passes.arcs, BURIN_TEXT("Command", "%1 arc was converted to lines within 0.001 mm; fit-arcs restores it."),
        BURIN_TEXT("Command", "%1 arcs were converted to lines within 0.001 mm; fit-arcs restores them."));
    add(passes.dwells, BURIN_TEXT("Command", "%1 dwell was left out."),
        BURIN_TEXT("Command", "%1 dwells were left out."));
    add(passes.startless, BURIN_TEXT("Command", "%1 move was left out: the program does not state where it begins."),
        BURIN_TEXT("Command", "%1 moves were left out: the program does not state where they begin."));
    return text;
}

/// The requested tool, or all tools that the project's tool numbers may refer to. Errors: those of toolFor and
/// Project::tools.
Result<ToolChoice> toolsMeant(const Project& project, const std::string& asked) {
    if (asked.empty()) {
        Result<std::vector<Tool>> tools = project.tools();
        return tools ? Result<ToolChoice>(ToolChoice{std::move(*tools), false}) : std::move(tools).error();
    }
    const Result<Tool> tool = toolFor(project, asked);
    return tool ? Result<ToolChoice>(ToolChoice{{*tool}, true}) : tool.error();
}

/// Stores each pass as a source of its tool's path. Errors: those of Project.
Result<std::vector<StoredPath>> keep(Project& project, const ProgramPasses& passes, const std::string& name) {
    std::vector<StoredPath> paths;
    std::vector<std::string> tools;
    for (const ProgramPass& pass : passes.passes) {
        const Result<std::int64_t> source = project.addGenerated(pass.moves);
        if (!source) return source.error();
        if (const Result<void> kept = project.setTool(pass.tool); !kept) return kept.error();
        const auto place = static_cast<std::size_t>(std::ranges::find(tools, pass.tool.id) - tools.begin());
        if (place == tools.size()) {
            tools.push_back(pass.tool.id);
            paths.push_back({0, name, {}, {}});
        }
        paths[place] = withProgram(std::move(paths[place]), pass.moves.info.name, useOf(pass), *source);
    }
    for (StoredPath& path : paths) {
        const Result<std::int64_t> id = project.addPath(path);
        if (!id) return id.error();
        path.id = *id;
    }
    return paths;
}

} // namespace

int addProgramPaths(ProjectChange& project, const ProgramPathArguments& arguments, const std::string& machine,
                    CommandContext& context) {
    const Result<std::string> text = readFile(arguments.file);
    if (!text) return context.fail(text.error());
    if (text->empty()) return context.fail({ErrorCode::fileEmpty, arguments.file, {}, {}});
    const Result<ToolChoice> tools = toolsMeant(*project, arguments.tool);
    if (!tools) return context.fail(tools.error());
    if (tools->tools.empty())
        return context.fail(
            {ErrorCode::argumentInvalid, "--tool", "", worded(BURIN_TEXT("Command", "a tool for the program"))});
    context.stage(BURIN_TEXT("Command", "Opening"));
    const Result<MillingContext> milling =
        makeMillingContext(*project, tools->tools.front(), machineFor(*project, machine, context), context.progress());
    if (!milling) return context.fail(milling.error());
    const Result<ProgramTarget> target = project->programTarget();
    if (!target) return context.fail(target.error());
    const std::string dialect = dialectFor(arguments.dialect, *target, milling->machine);
    if (const auto known = loadDialect(dialect); !known) return context.fail(known.error());
    context.stage(BURIN_TEXT("Command", "Reading the program"));
    const Result<ProgramPasses> passes =
        passesOfProgram(*text, arguments.file, dialect, *milling, *tools, context.progress());
    if (!passes) return context.fail(passes.error());
    const Result<std::vector<StoredPath>> paths = keep(*project, *passes, arguments.name);
    if (!paths) return context.fail(paths.error());
    if (const Result<void> saved = project.save(); !saved) return context.fail(saved.error());
    tellKeptEarlier(context, *project);
    nlohmann::json answer{
        {"paths", nlohmann::json::array()},    {"arcs_as_chords", passes->arcs},
        {"chord_tolerance_mm", arcChord},      {"dwells_left_out", passes->dwells},
        {"moves_left_out", passes->startless}, {"passes_with_coolant_changes", passes->coolantChanges()}};
    std::string lines;
    answer["length_mm"] = passes->length();
    for (const StoredPath& path : *paths) {
        const Result<std::vector<GeneratedInfo>> made = passesOf(*project, path);
        if (!made) return context.fail(made.error());
        answer["paths"].push_back(jsonOf(path, *made));
        lines += textOf(path, *made) + "\n";
    }
    context.answer(answer,
                   lines + worded(BURIN_TEXT("Command", "%1 mm of feed moves"), {formatFixed(passes->length(), 1)}) +
                       textOfLosses(*passes));
    return 0;
}

} // namespace burin
