// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/chosen_setup.h"
#include "app/command.h"
#include "app/commands/mill_options.h"
#include "app/report.h"
#include "app/surroundings.h"
#include "app/take_moment_argument.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/base/staged_file.h"
#include "core/base/units.h"
#include "core/device/axis_map_json.h"
#include "core/device/device_registry.h"
#include "core/document/companions.h"
#include "core/haptics/trace/trace_stylus.h"
#include "core/job/milling.h"
#include "core/job/recorded_cuts.h"
#include "core/job/switched_off.h"
#include "core/volume/operations/fingerprint.h"
#include "ui/dialogs/preferences.h"
#include "ui/messages/messages.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

namespace burin {

namespace {

using nlohmann::json;

constexpr std::string_view tracePrefix = "trace:";
constexpr std::string_view devicePrefix = "device:";

const char* nameOf(FeedBound bound) {
    switch (bound) {
    case FeedBound::chip:
        return "chip";
    case FeedBound::plunge:
        return "plunge";
    case FeedBound::thinned:
        return "thin-chip";
    case FeedBound::load:
        return "load";
    case FeedBound::limit:
        break;
    }
    return "limit";
}

/// The most demanding cut of a take, and the feed for it; null if nothing was cut, or the tables lack values.
json heaviestCutOf(const TakeOutcome& outcome, const PropertyList& properties) {
    if (!outcome.heaviestFeed) return nullptr;
    const SmoothedCut& cut = outcome.heaviestCut;
    const FeedProposal& feed = *outcome.heaviestFeed;
    return {{"area_mm2", cut.area},         {"engagement_rad", cut.arc},
            {"depth_mm", cut.depth},        {"material", properties[feed.material].id},
            {"feed_mm_per_min", feed.feed}, {"spindle_speed_rpm", feed.spindleSpeed},
            {"bound", nameOf(feed.bound)}};
}

json jsonOf(const TakeOutcome& outcome, const ToolBounds& bounds, const PropertyList& properties) {
    json layers = jsonOf(bounds.layers());
    for (std::size_t i = 0; i < layers.size(); ++i) layers[i]["ticks_held"] = outcome.layerTicks[i];
    return {{"take", outcome.take},
            {"layers", layers},
            {"obstacle_ticks", outcome.obstacleTicks},
            {"axis_held_ticks", outcome.axisHeldTicks},
            {"stock_distance_ticks", outcome.stockTicks},
            {"samples", outcome.samples},
            {"ticks", outcome.loop.ticks},
            {"rate_hz", outcome.loop.rateHz},
            {"tick_us_p50", outcome.loop.workP50},
            {"tick_us_p999", outcome.loop.workP999},
            {"tick_cpu_us_p50", outcome.loop.cpuP50},
            {"tick_cpu_us_p999", outcome.loop.cpuP999},
            {"missed", outcome.loop.missed},
            {"interval_us_p50", outcome.loop.intervalP50},
            {"interval_us_p999", outcome.loop.intervalP999},
            {"late", outcome.loop.late},
            {"motor_cuts", outcome.loop.cuts},
            {"scheduling", nameOf(outcome.loop.scheduling)},
            {"memory_locked", outcome.loop.memoryLocked},
            {"duration_s", outcome.loop.simulatedSeconds},
            {"removed_mm3", outcome.removed},
            {"workpiece_drop_mm3", outcome.drop},
            {"shank_contact_ticks", outcome.shankTicks},
            {"force_max_n", outcome.largestForce},
            {"torque_max_n_mm", outcome.largestTorque},
            {"cutting_force_max_n", outcome.largestCuttingForce},
            {"heaviest_cut", heaviestCutOf(outcome, properties)}};
}

/// Objects other than the part that held the tool, and motion that could not follow the hand.
std::string alarmsOf(const TakeOutcome& outcome, const ToolBounds& bounds) {
    std::string text;
    const auto add = [&text](std::uint64_t ticks, TextId what, const std::string& holder = {}) {
        if (ticks > 0) text += worded(what, {std::to_string(ticks), holder});
    };
    add(outcome.shankTicks, BURIN_TEXT("Command", "; shank or holder touched in %1 ticks"));
    for (std::size_t i = 1; i < bounds.layers().size(); ++i)
        add(outcome.layerTicks[i], BURIN_TEXT("Command", "; %2 held the tool in %1 ticks"), textOf(bounds.layers()[i]));
    add(outcome.stockTicks, BURIN_TEXT("Command", "; shank or holder were kept away from the stock in %1 ticks"));
    add(outcome.axisHeldTicks, BURIN_TEXT("Command", "; the axis was held in %1 ticks"));
    return text;
}

std::string heaviestText(const TakeOutcome& outcome, const PropertyList& properties) {
    if (!outcome.heaviestFeed) return {};
    const SmoothedCut& cut = outcome.heaviestCut;
    const FeedProposal& feed = *outcome.heaviestFeed;
    return worded(BURIN_TEXT("Command",
                             "; heaviest cut: %1 mm^2 of %2, engagement %3 degrees, depth %4 mm; feed for it: "
                             "%5 mm/min at %6 rpm"),
                  {formatFixed(cut.area, 2), properties[feed.material].id, formatFixed(cut.arc * 180.0 / pi, 0),
                   formatFixed(cut.depth, 2), formatFixed(feed.feed, 0), formatFixed(feed.spindleSpeed, 0)});
}

std::string textOf(const TakeOutcome& outcome, const ToolBounds& bounds, const PropertyList& properties) {
    return worded(BURIN_TEXT("Command", "take %1: %2 samples, %3 s, removed %4 mm^3; tick %5 us (p50), %6 us (p99.9), "
                                        "%7 Hz"),
                  {std::to_string(outcome.take), std::to_string(outcome.samples),
                   formatFixed(outcome.loop.simulatedSeconds, 1), formatFixed(outcome.removed, 1),
                   formatFixed(outcome.loop.workP50, 1), formatFixed(outcome.loop.workP999, 1),
                   formatFixed(outcome.loop.rateHz, 0)}) +
           heaviestText(outcome, properties) + alarmsOf(outcome, bounds);
}

/// The work to be done with one stylus on a project.
struct MillWork {
    const MillArguments& arguments;
    Project& project;
    MillingContext& milling;
    const ToolBounds& bounds;
    CommandContext& context;
    Pace pace;
    json& answer;                          ///< receives the values reported for the whole session
    std::optional<StagedFile>& trace;      ///< receives the requested trace
    OpenedSessionTrace* played;            ///< the trace that serves as the stylus; null: none
    std::optional<GuideSettings> guides{}; ///< for hand guidance
    double assist = 0.0;                   ///< as in FeltCutting
};

/// Reports the share of the cutting force that was felt, and the source of this value.
void tellFelt(const FeltCutting& felt, const char* source, json& answer) {
    answer["felt"] = {{"gain", felt.gain}, {"friction", felt.friction}, {"source", source}};
}

/// Reports the distance that shank and holder keep from the stock, mm; null: none.
void tellStockDistance(const StockLayer& stock, json& answer) {
    answer["stock_distance_mm"] = stock.distance > 0.0 && stock.on ? json(stock.distance) : json(nullptr);
}

StockLayer askedStock(const MillArguments& arguments) {
    return {arguments.stockDistance.value_or(0.0), arguments.stockDistance.has_value()};
}

/// For a trace of an older version, a hand-written one or that of a take: readings alone do not say what was felt.
FeltCutting feltWithout(const std::string& file, const MillWork& work) {
    FeltCutting felt = feltByPlannedHand;
    felt.gain = work.arguments.felt.value_or(felt.gain);
    tellFelt(felt, work.arguments.felt ? "argument" : "assumed", work.answer);
    if (!work.arguments.felt)
        work.context.message(
            worded(BURIN_TEXT("Command", "\"%1\" does not state how much of the cutting force was felt: %2 of it is "
                                         "assumed, as for the virtual operator. Set it with --felt; positions and the "
                                         "removed material don't depend on it, forces do."),
                   {file, formatShortest(felt.gain)}));
    return felt;
}

/// Configures a request like the session that recorded a trace, except that the allowance may be given anew.
/// Errors: argumentInvalid (its tool had another axis).
Result<void> playAgain(const SessionTrace& trace, const MillWork& work, TakeRequest& request) {
    request.replayed = &trace;
    if (!trace.began) {
        request.felt = feltWithout(work.arguments.stylus.substr(tracePrefix.size()), work);
        return {};
    }
    const AxisMode &then = trace.began->axis, &now = work.bounds.axis();
    if (then.free != now.free || (!now.free && glm::length(then.direction - now.direction) > 1e-9))
        return Error{ErrorCode::argumentInvalid, "--axis", textOf(now),
                     worded(BURIN_TEXT("Command", "%1, as when the trace was recorded"), {textOf(then)})};
    request.mapping = trace.began->mapping;
    request.period = trace.began->period;
    request.cutsOnButton = trace.began->cutsOnButton;
    request.forceButtons = trace.began->forceButtons;
    if (work.arguments.felt)
        return Error{
            ErrorCode::argumentInvalid, "--stylus", work.arguments.stylus,
            worded(BURIN_TEXT("Command",
                              "with --felt, a trace that does not state how much of the cutting force was felt"))};
    if (work.arguments.stockDistance)
        return Error{
            ErrorCode::argumentInvalid, "--stylus", work.arguments.stylus,
            worded(BURIN_TEXT("Command", "with --stock-distance, a trace that does not state this distance itself"))};
    request.stock = trace.began->stock;
    tellStockDistance(request.stock, work.answer);
    request.felt = trace.began->felt;
    tellFelt(request.felt, "trace", work.answer);
    request.allowance = work.arguments.allowance.value_or(trace.began->allowance);
    return {};
}

/// Records one take with a stylus, until it ends, the given time has passed, or a stop is requested.
Result<std::vector<TakeOutcome>> millWith(const StylusHandle& stylus, const std::string& name, bool cutsOnButton,
                                          const MillWork& work, const SessionTrace* replayed = nullptr) {
    TakeRequest request;
    request.name = name;
    request.allowance = work.arguments.allowance.value_or(0.0);
    request.mapping = mappingFor(work.milling, stylus.device().description());
    request.pace = work.pace;
    request.cutsOnButton = cutsOnButton;
    request.period = 1.0 / work.arguments.rate;
    if (work.played == nullptr && work.arguments.felt) request.felt.gain = *work.arguments.felt;
    request.felt.assist = work.assist;
    request.trace = work.arguments.trace;
    request.traceOutput = &work.trace;
    request.saves = false;
    request.guides = work.guides;
    request.stock = askedStock(work.arguments);
    tellStockDistance(request.stock, work.answer);
    if (work.arguments.deadMan > 0) request.forceButtons = 1U << static_cast<unsigned>(work.arguments.deadMan - 1);
    request.heardFault = [&work](const Error& fault) { work.context.message(Messages::sentence(fault).toStdString()); };
    if (work.arguments.seconds > 0.0) request.maximumSeconds = work.arguments.seconds;
    if (replayed != nullptr)
        if (Result<void> asThen = playAgain(*replayed, work, request); !asThen) return std::move(asThen).error();
    Result<TakeOutcome> outcome =
        recordTake(work.project, work.milling, work.bounds, stylus, request, work.context.progress().cancelFlag());
    if (!outcome) return std::move(outcome).error();
    return std::vector<TakeOutcome>{std::move(*outcome)};
}

Result<std::vector<TakeOutcome>> millWithTrace(OpenedSessionTrace& trace, const MillWork& work) {
    const SessionTrace& session = trace.session;
    TraceStylus stylus(std::move(trace.readings), session.began ? session.began->stylus : touchLikeStylus());
    const std::filesystem::path file = work.arguments.stylus.substr(tracePrefix.size());
    Result<std::vector<TakeOutcome>> takes = millWith(stylus, file.stem().string(), false, work, &session);
    if (const Result<void> played = stylus.outcome(); takes && !played) return played.error();
    return takes;
}

/// Reports how many guides of the project are active.
void tellGuides(const MillWork& work) {
    const auto count = work.guides ? std::ranges::count_if(work.guides->guides, &Guide::on) : 0;
    work.answer["guides"] = count;
    if (count > 0)
        work.context.message(
            worded(BURIN_TEXT("Command", "Active guides of the project: %1"), {std::to_string(count)}));
}

/// The first button of the device, if it has one, controls the spindle.
Result<std::vector<TakeOutcome>> millWithDevice(const std::string& name, const MillWork& work) {
    DeviceRegistry registry;
    const Result<FoundDevice> device = registry.find(name);
    for (const Error& fault : registry.takeFaults()) work.context.message(Messages::sentence(fault).toStdString());
    if (!device) return device.error();
    if (work.arguments.fast)
        return Error{ErrorCode::argumentInvalid, "--fast", device->id,
                     worded(BURIN_TEXT("Command", "--realtime with a device"))};
    const Result<AnyStylus> stylus = registry.make(device->id, work.arguments.mode);
    if (!stylus) return stylus.error();
    const StylusHandle handle(*stylus);
    if (Result<void> assigned = assignKept(handle.device(), UserSettings().axisMap(device->id)); !assigned)
        return std::move(assigned).error();
    const int buttons = handle.device().description().buttons;
    if (work.arguments.deadMan > buttons)
        return Error{ErrorCode::argumentInvalid, "--dead-man", std::to_string(work.arguments.deadMan),
                     worded(BURIN_TEXT("Command", "%1 to %2"), {"0", std::to_string(buttons)})};
    FeltCutting felt;
    felt.gain = work.arguments.felt.value_or(felt.gain);
    tellFelt(felt, work.arguments.felt ? "argument" : "usual", work.answer);
    const Result<KeptGuides> guides = work.project.guides(); // its curves are needed until the session is over
    if (!guides) return guides.error();
    MillWork live = work;
    live.pace = Pace::realtime;
    if (!work.arguments.noGuides) live.guides = guideSettings(guides->guides, guides->stepButton);
    live.assist = work.arguments.assist.value_or(UserSettings().felt(device->id).assist);
    if (handle.device().description().assist.works()) work.answer["assist"] = live.assist;
    tellGuides(live);
    return millWith(handle, device->name, buttons > 0, live);
}

Result<std::vector<TakeOutcome>> millAsAsked(const MillWork& work) {
    const std::string& stylus = work.arguments.stylus;
    if (work.arguments.assist && !stylus.starts_with(devicePrefix))
        return Error{ErrorCode::argumentInvalid, "--assist", formatShortest(*work.arguments.assist),
                     worded(BURIN_TEXT("Command", "no value, unless --stylus is a device"))};
    if (work.played != nullptr) return millWithTrace(*work.played, work);
    if (stylus.starts_with(devicePrefix)) return millWithDevice(stylus.substr(devicePrefix.size()), work);
    if (work.arguments.felt)
        return Error{ErrorCode::argumentInvalid, "--felt", formatShortest(*work.arguments.felt),
                     worded(BURIN_TEXT("Command", "no value, unless --stylus is a device or a trace that does not "
                                                  "state how much of the cutting force was felt"))};
    if (stylus != "operator")
        return Error{ErrorCode::nameUnknown, "stylus", stylus,
                     worded(BURIN_TEXT("Command", "operator, trace:FILE, device:NAME"))};
    if (!work.arguments.trace.empty())
        return Error{
            ErrorCode::argumentInvalid, "--trace", work.arguments.trace,
            worded(BURIN_TEXT("Command", "no file with the operator; one if --stylus is a trace or a device"))};
    OperatorRequest request = work.arguments.hand;
    request.hand = gripOf(work.arguments);
    request.intent = intentOf(work.arguments);
    request.allowance = work.arguments.allowance.value_or(request.allowance);
    request.timeLimit = work.arguments.seconds;
    request.stock = askedStock(work.arguments);
    tellStockDistance(request.stock, work.answer);
    request.pace = work.pace;
    request.saves = false;
    Result<OperatorOutcome> outcome =
        millWithOperator(work.project, work.milling, work.bounds, request, work.context.progress().cancelFlag());
    if (!outcome) return std::move(outcome).error();
    work.answer["levels_mm"] = outcome->plan.levels;
    return std::move(outcome->takes);
}

/// The bounds of the tool, by the project or by the arguments. With a hand, not all of them have to be computed first.
Result<ToolBounds> boundsFor(const Project& project, const MillingContext& milling, const MillArguments& arguments,
                             const SessionTrace* played, Progress& progress) {
    const Result<AxisMode> axis = arguments.axis.empty() ? project.axisMode() : axisModeOf(arguments.axis);
    if (!axis) return axis.error();
    const Result<TravelPlacement> travel = project.travelPlacement();
    if (!travel) return travel.error();
    const Surroundings surroundings = surroundingsOf(milling, *travel, *axis);
    if (played != nullptr && played->began && played->began->growth && !axis->free)
        return ToolBounds::asGrown(milling, milling.tool, *axis, surroundings, *played, progress);
    const double allowance = std::max(arguments.allowance.value_or(arguments.hand.allowance), 0.5);
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
    const Result<Tool> tool = toolFor(*project, arguments.tool);
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

    std::optional<OpenedSessionTrace> played;
    if (arguments.stylus.starts_with(tracePrefix)) {
        Result<OpenedSessionTrace> trace = openSessionTrace(arguments.stylus.substr(tracePrefix.size()));
        if (!trace) return nothingMilled(trace.error());
        played = std::move(*trace);
    }

    context.stage(BURIN_TEXT("Command", "Computing the tool's boundary"));
    const Result<ToolBounds> bounds =
        boundsFor(*project, *milling, arguments, played ? &played->session : nullptr, context.progress());
    if (!bounds) return nothingMilled(bounds.error());

    context.stage(BURIN_TEXT("Command", "Milling"));
    json answer;
    std::optional<StagedFile> trace;
    const auto outcome =
        millAsAsked({arguments, *project, *milling, *bounds, context, arguments.realtime ? Pace::realtime : Pace::fast,
                     answer, trace, played ? &*played : nullptr});
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
