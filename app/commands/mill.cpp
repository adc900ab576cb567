// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/chosen_setup.h"
#include "app/command.h"
#include "app/commands/mill_report.h"
#include "app/commands/mill_session.h"
#include "app/report.h"
#include "app/surroundings.h"
#include "app/take_moment_argument.h"
#include "app/wording.h"
#include "core/base/staged_file.h"
#include "core/document/companions.h"
#include "core/job/milling.h"
#include "core/job/recorded_cuts.h"
#include "core/job/switched_off.h"
#include "core/job/traced_bounds.h"
#include "core/volume/operations/fingerprint.h"
#include "ui/messages/messages.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

namespace burin {

namespace {

using nlohmann::json;

constexpr const char* usualTool = "ball-6";

/// Empty: the stylus is none.
Result<std::optional<OpenedSessionTrace>> traceToPlay(const MillArguments& arguments) {
    if (!arguments.stylus.starts_with(tracePrefix)) return std::optional<OpenedSessionTrace>();
    Result<OpenedSessionTrace> trace = openSessionTrace(arguments.stylus.substr(tracePrefix.size()));
    if (!trace) return std::move(trace).error();
    return std::optional<OpenedSessionTrace>(std::move(*trace));
}

/// The tool that the arguments name, else that of the trace.
std::string toolToMill(const MillArguments& arguments, const SessionTrace* played) {
    if (!arguments.tool.empty()) return arguments.tool;
    return played != nullptr && played->began && !played->began->tool.empty() ? played->began->tool : usualTool;
}

/// The bounds of the tool, by the arguments, the trace or the project. With a hand, not all of them have to be computed
/// first.
Result<ToolBounds> boundsFor(const Project& project, const MillingContext& milling, const MillArguments& arguments,
                             const SessionTrace* played, Progress& progress) {
    Result<AxisMode> axis = arguments.axis.empty() ? project.axisMode() : axisModeOf(arguments.axis);
    if (!axis) return axis.error();
    if (arguments.axis.empty() && played != nullptr && played->began) axis = played->began->axis;
    const Result<TravelPlacement> travel = project.travelPlacement();
    if (!travel) return travel.error();
    const double allowance = std::max(arguments.allowance.value_or(arguments.hand.allowance), 0.5);
    if (played != nullptr) return boundsAsTraced(milling, *axis, *travel, allowance, *played, progress);
    const Surroundings surroundings = surroundingsOf(milling, *travel, *axis);
    if (!arguments.stylus.starts_with(devicePrefix))
        return ToolBounds::build(milling, milling.tool, *axis, surroundings, allowance, progress);
    return ToolBounds::grow(milling, lent(milling.part), milling.tool, *axis, surroundings, allowance, {}, progress);
}

/// Saves the milled work together with the trace: both or neither.
Result<void> saveWith(Project& project, std::optional<StagedFile>& trace) {
    const Result<void> saved = project.save(trace ? std::span(&*trace, 1) : std::span<StagedFile>());
    if (saved) project.abandonChanges(); // all of them are in the file
    return saved;
}

/// What remains of a recording and its trace after a fault.
QString keptRecording(const Project& project, const std::optional<StagedFile>& trace) {
    QStringList words;
    if (trace) words << standingOutputs(std::span(&*trace, 1));
    if (const Result<bool> unsaved = project.unsaved(); unsaved && *unsaved)
        words << Messages::text(
            BURIN_TEXT("Command", "the recording is kept, and the next command that opens the project recovers it"));
    words.removeAll(QString());
    return words.join("; ");
}

/// Errors: those of checkOutput.
Result<void> checkTrace(const MillArguments& arguments) {
    if (arguments.trace.empty()) return {};
    const bool plays = arguments.stylus.starts_with(tracePrefix);
    const std::array<std::filesystem::path, 2> inputs{
        arguments.project, plays ? arguments.stylus.substr(tracePrefix.size()) : std::string()};
    return checkOutput("--trace", arguments.trace, inputs);
}

/// Switches off everything recorded after a moment. @return what was off before
Result<SwitchedOff> punchIn(Project& project, const std::string& from) {
    const Result<TakeMoment> moment = momentOf(project, from);
    if (!moment) return moment.error();
    const Result<SwitchedOff> off = offAfter(project, *moment);
    if (!off) return off.error();
    Result<SwitchedOff> before = switchedOff(project, *off);
    if (!before) return before;
    if (Result<void> done = setSwitchedOff(project, *off); !done) return std::move(done).error();
    return before;
}

/// Keeps the workpiece, so that opening the project again needs no cutting. A failure to keep it is ignored.
void keepWorkpiece(Project& project, MillingContext& milling, Progress& progress) {
    const Result<std::vector<TakeInfo>> takes = project.takes();
    if (!takes || takes->empty()) return;
    const Result<RecordedWork> work = recordedWork(project);
    if (!work) return;
    const Result<KeptWorkpiece> kept =
        keptAs(milling.embedded.workpiece.snapshot(), work->end, work->strokes, progress);
    const Result<RecordedState> state = project.recordedState();
    if (kept && state) static_cast<void>(project.keepWorkpiece(*kept, *state));
}

int runMill(const MillArguments& arguments, CommandContext& context) {
    if (const Result<void> free = checkTrace(arguments); !free) return context.fail(free.error());
    context.stage(BURIN_TEXT("Command", "Opening"));
    Result<Project> project = projectToMill(arguments.project, context);
    if (!project) return context.fail(project.error());
    Result<std::optional<OpenedSessionTrace>> opened = traceToPlay(arguments);
    if (!opened) return context.fail(opened.error());
    const SessionTrace* const played = *opened ? &(*opened)->session : nullptr;
    const Result<Tool> tool = toolFor(*project, toolToMill(arguments, played));
    if (!tool) return context.fail(tool.error());
    Result<MillingContext> milling =
        makeMillingContext(*project, *tool, machineFor(*project, arguments.machine, context), context.progress());
    if (!milling) return context.fail(milling.error());
    if (const std::string refusal = unprotected(milling->embedded); !refusal.empty() && !arguments.overrides) {
        const std::vector<std::string> doubts = doubtsOf(*milling->model, milling->embedded);
        context.answer({{"takes", json::array()}, {"part_warnings", doubts}},
                       worded(BURIN_TEXT("Command", "nothing was milled")) +
                           textOfDoubts(*milling->model, milling->embedded));
        context.message(refusal);
        return static_cast<int>(ErrorClass::checkFailed);
    }
    const Result<SwitchedOff> off =
        arguments.from.empty() ? Result<SwitchedOff>(SwitchedOff{}) : punchIn(*project, arguments.from);
    if (!off) return context.fail(off.error());
    const auto nothingMilled = [&](const Error& error) { // restores what was active before
        static_cast<void>(setSwitchedOff(*project, *off));
        return context.fail(error);
    };
    const Result<std::vector<TakeInfo>> before = project->takes();
    if (!before) return nothingMilled(before.error());
    const bool fresh = before->empty();
    if (const Result<void> replayed = replayTakes(*project, *milling, context.progress()); !replayed)
        return nothingMilled(replayed.error());

    context.stage(BURIN_TEXT("Command", "Computing the tool's boundary"));
    const Result<ToolBounds> bounds = boundsFor(*project, *milling, arguments, played, context.progress());
    if (!bounds) return nothingMilled(bounds.error());

    context.stage(BURIN_TEXT("Command", "Milling"));
    json answer;
    std::optional<StagedFile> trace;
    const auto outcome =
        millAsAsked({arguments, *project, *milling, *bounds, context, arguments.realtime ? Pace::realtime : Pace::fast,
                     answer, trace, *opened ? &**opened : nullptr});
    if (!outcome) {
        // An interrupted recording is saved as if it had ended by itself.
        const bool ended = outcome.error().code == ErrorCode::cancelled && project->unsaved() && *project->unsaved();
        if (ended && saveWith(*project, trace)) return context.fail(outcome.error());
        return context.fail(outcome.error(), keptRecording(*project, trace));
    }
    keepWorkpiece(*project, *milling, context.progress());
    if (const Result<void> saved = saveWith(*project, trace); !saved)
        return context.fail(saved.error(), keptRecording(*project, trace));
    tellKeptEarlier(context, *project);

    const Box& travel = bounds->envelope().tips;
    const std::vector<std::string> doubts = doubtsOf(*milling->model, milling->embedded);
    answer.update({{"project", std::filesystem::absolute(arguments.project).lexically_normal().string()},
                   {"tool", jsonOf(milling->tool)},
                   {"axis", jsonOf(bounds->axis())},
                   {"layers", jsonOf(bounds->layers())},
                   {"machine_travel_mm", travel.empty() ? json(nullptr) : jsonOf(travel)},
                   {"part_warnings", doubts},
                   {"takes", json::array()}});
    double removed = 0.0;
    std::uint64_t samples = 0;
    std::string text;
    const PropertyList& properties = milling->embedded.workpiece.properties();
    for (const TakeOutcome& take : *outcome) {
        answer["takes"].push_back(jsonOf(take, *bounds, properties));
        removed += take.removed;
        samples += take.samples;
        text += (text.empty() ? "" : "\n") + textOf(take, *bounds, properties);
    }
    answer["samples"] = samples;
    answer["removed_mm3"] = removed;
    answer["workpiece_hash"] = fingerprintText(fingerprint(milling->embedded.workpiece.snapshot()));
    context.answer(answer, text + textOfDoubts(*milling->model, milling->embedded));
    if (context.progress().cancelled()) return static_cast<int>(ErrorClass::cancelled);
    const bool idle = fresh && arguments.stylus == "operator" && arguments.intent == "passes" &&
                      !(arguments.seconds > 0.0) && !(removed > 0.0) && !arguments.overrides;
    if (!idle) return 0;
    context.message(
        worded(BURIN_TEXT("Command", "The tool can't reach anything to mill. Use a smaller or longer tool, or "
                                     "accept it with --override.")));
    return static_cast<int>(ErrorClass::checkFailed);
}

} // namespace

void registerMill(CommandParser program, CommandContext& context, int& status) {
    auto arguments = std::make_shared<MillArguments>();
    const CommandParser command =
        program.command("mill", BURIN_TEXT("Help", "Mill a project's workpiece with a stylus and record it"));
    addMillOptions(command, *arguments);
    addSetupChoice(command, context);
    addJsonFlag(command, context);
    command.run([arguments, &context, &status] { status = runMill(*arguments, context); });
}

} // namespace burin
