// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/commands/mill_trace.h"

#include "app/surroundings.h"
#include "app/wording.h"
#include "core/base/numbers.h"

namespace burin {

namespace {

using nlohmann::json;

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

} // namespace

void tellFelt(const FeltCutting& felt, const char* source, json& answer) {
    answer["felt"] = {{"gain", felt.gain}, {"friction", felt.friction}, {"source", source}};
}

void tellStockDistance(const StockLayer& stock, json& answer) {
    answer["stock_distance_mm"] = stock.distance > 0.0 && stock.on ? json(stock.distance) : json(nullptr);
}

void tellGains(const GainLimits& gains, json& answer) {
    const auto limit = [](double value) { return value < GainLimits::none ? json(value) : json(nullptr); };
    if (gains != GainLimits{})
        answer["gain_limits"] = {{"stiffness_n_per_m", limit(gains.stiffness)},
                                 {"damping_n_s_per_m", limit(gains.damping)}};
}

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
    request.gains = trace.began->gains;
    tellGains(request.gains, work.answer);
    request.allowance = work.arguments.allowance.value_or(trace.began->allowance);
    return {};
}

} // namespace burin
