// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/commands/mill_session.h"

#include "app/commands/mill_trace.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/device/axis_map_json.h"
#include "core/device/device_registry.h"
#include "core/haptics/trace/trace_stylus.h"
#include "ui/dialogs/preferences.h"
#include "ui/messages/messages.h"

#include <algorithm>

namespace burin {

namespace {

using nlohmann::json;

StockLayer askedStock(const MillArguments& arguments) {
    return {arguments.stockDistance.value_or(0.0), arguments.stockDistance.has_value()};
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
    request.gains = work.gains;
    tellGains(request.gains, work.answer);
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
    live.gains = UserSettings().gains(device->id).inForce();
    tellGuides(live);
    return millWith(handle, device->name, buttons > 0, live);
}

} // namespace

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

} // namespace burin
