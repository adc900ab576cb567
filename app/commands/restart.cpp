// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/commands/restart.h"
#include "app/chosen_setup.h"

#include "app/report.h"
#include "app/surroundings.h"
#include "app/wording.h"
#include "core/base/file.h"
#include "core/base/numbers.h"
#include "core/job/kept_program.h"
#include "core/job/restart_job.h"
#include "core/job/setup_title.h"

#include <filesystem>

namespace burin {

namespace {

/// A program that was interrupted, and its target.
struct Interrupted {
    std::string text, dialect, machine;
    NcUnits units = NcUnits::millimetre;
};

/// The newest program in the project. Errors: projectIncomplete.
Result<Interrupted> keptIn(const Project& project, CommandContext& context) {
    const Result<std::optional<ReopenedProgram>> reopened = reopenProgram(project);
    if (!reopened) return reopened.error();
    if (*reopened) {
        const KeptProgram& kept = (*reopened)->kept;
        if (!(*reopened)->upToDate)
            context.message(worded(BURIN_TEXT("Command", "The project changed after its program was posted; the "
                                                         "restart is judged by the project as it is now.")));
        return Interrupted{kept.text, kept.dialect, kept.machine, kept.units};
    }
    const Result<std::vector<StoredProgram>> programs = project.programs();
    if (!programs) return programs.error();
    if (programs->empty()) return Error{ErrorCode::projectIncomplete, "program", "burin post", {}};
    const StoredProgram& last = programs->back();
    const Result<ProgramTarget> target = project.programTarget();
    if (!target) return target.error();
    return Interrupted{last.text, last.dialect, last.machine, target->units};
}

Result<Interrupted> interruptedProgram(const Project& project, const RestartArguments& arguments,
                                       CommandContext& context) {
    if (arguments.program.empty()) return keptIn(project, context);
    Result<std::string> text = readFile(arguments.program);
    if (!text) return std::move(text).error();
    const Result<ProgramTarget> target = project.programTarget();
    if (!target) return target.error();
    return Interrupted{std::move(*text), {}, {}, target->units};
}

/// Tools that a program of the project may call.
Result<std::vector<Tool>> toolsIn(const Project& project) {
    Result<std::vector<Tool>> tools = project.tools();
    if (!tools || !tools->empty()) return tools;
    const Result<std::vector<TakeInfo>> takes = project.takes();
    if (!takes) return takes.error();
    if (takes->empty()) return Error{ErrorCode::projectIncomplete, "recording", "burin mill", {}};
    Result<Tool> tool = toolFor(project, takes->front().toolId);
    if (!tool) return std::move(tool).error();
    return std::vector{std::move(*tool)};
}

std::string textOf(const RestartedProgram& restart) {
    return worded(BURIN_TEXT("Command", "first cut: line %1 of the interrupted program, from %2 mm of path before it; "
                                        "the tool comes down at %3"),
                  {std::to_string(restart.line), formatFixed(restart.lead, 1), placeText(restart.place)});
}

} // namespace

int runRestart(const RestartArguments& arguments, CommandContext& context) {
    context.stage(BURIN_TEXT("Command", "Opening"));
    const Result<Project> project = projectToMill(arguments.project, context);
    if (!project) return context.fail(project.error());
    Result<Interrupted> interrupted = interruptedProgram(*project, arguments, context);
    if (!interrupted) return context.fail(interrupted.error());
    Result<std::vector<Tool>> tools = toolsIn(*project);
    if (!tools) return context.fail(tools.error());
    const std::string& asked = arguments.machine.empty() ? interrupted->machine : arguments.machine;
    const Result<MillingContext> milling =
        makeMillingContext(*project, tools->front(), machineFor(*project, asked, context), context.progress());
    if (!milling) return context.fail(milling.error());
    const Result<ProgramTarget> target = project->programTarget();
    if (!target) return context.fail(target.error());

    context.stage(BURIN_TEXT("Command", "Restarting and checking"));
    ProgramRequest request;
    request.name = std::filesystem::path(arguments.output).filename().string();
    const Result<std::string> title = setupTitle(*project);
    if (!title) return context.fail(title.error());
    request.setupName = *title;
    request.dialect =
        dialectFor(arguments.dialect.empty() ? interrupted->dialect : arguments.dialect, *target, milling->machine);
    request.gougeTolerance = arguments.tolerance;
    request.units = ncUnitsFromId(arguments.units).value_or(interrupted->units);
    request.tools = std::move(*tools);
    Result<RestartedProgram> restart =
        makeRestart(*milling, interrupted->text, arguments.line, request, context.progress());
    if (!restart) return context.fail(restart.error());
    if (!restart->program.passed() && !arguments.overrideReason.empty()) {
        Result<CheckedProgram> overridden =
            overrideCheck(std::move(restart->program), arguments.overrideReason, milling->machine);
        if (!overridden) return context.fail(overridden.error());
        restart->program = std::move(*overridden);
    }

    const CheckedProgram& program = restart->program;
    nlohmann::json answer = jsonOf(program.report);
    answer["program"] = nullptr;
    answer["restart_line"] = arguments.line;
    answer["first_cut_line"] = restart->line;
    answer["lead_mm"] = restart->lead;
    answer["re_entry_mm"] = jsonOf(restart->place);
    answer["blocks"] = program.parsed.blocks;
    answer["machine"] = jsonOf(milling->machine);
    answer["passed"] = program.passed();
    answer["overridden"] = program.overridden;
    answer["lint"] = jsonOf(program.lint);
    const std::string verdict = textOf(*restart) + "\n" + textOf(program, arguments.tolerance, milling->machine);
    if (!program.released()) {
        context.answer(answer, verdict);
        context.message(notWritten(arguments.output));
        return static_cast<int>(ErrorClass::checkFailed);
    }
    if (const Result<void> written = writeFileAtomically(arguments.output, program.text); !written)
        return context.fail(written.error());
    answer["program"] = std::filesystem::absolute(arguments.output).lexically_normal().string();
    context.answer(answer, worded(BURIN_TEXT("Command", "%1: %2 blocks"),
                                  {arguments.output, std::to_string(program.parsed.blocks)}) +
                               "\n" + verdict);
    return 0;
}

} // namespace burin
