// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

namespace burin {
namespace {

/// Edits that rely on one another come in these steps; within a step any order goes. Time is lost with thinning, the
/// hold-out's promise with any later filter, and strokes with linking.
enum class Step { recorded, thinned, linked, fed };

struct StepOf {
    Step operator()(const DropAirCuts&) const { return Step::recorded; }
    Step operator()(const DropDwells&) const { return Step::recorded; }
    Step operator()(const Smooth&) const { return Step::recorded; }
    Step operator()(const HoldOut&) const { return Step::thinned; }
    Step operator()(const Simplify&) const { return Step::thinned; }
    Step operator()(const Link&) const { return Step::linked; }
    Step operator()(const SetFeed&) const { return Step::fed; }
};

/// Whether an edit may move the path, so that its deviation counts in the budget.
bool movesPath(const EditParameters& parameters) {
    return std::holds_alternative<Smooth>(parameters) || std::holds_alternative<HoldOut>(parameters) ||
           std::holds_alternative<Simplify>(parameters);
}

Result<void> checkOrder(const std::vector<Edit>& edits) {
    Step reached = Step::recorded;
    for (const Edit& edit : edits) {
        if (!edit.enabled) continue;
        if (Result<void> valid = validate(edit); !valid) return valid;
        const Step step = std::visit(StepOf{}, edit.parameters);
        if (step < reached || (step == reached && step >= Step::linked))
            return Error{ErrorCode::argumentInvalid, "edits", std::string(idOf(edit.parameters)),
                         "drop-air-cuts, drop-dwells and smooth come before hold-out and simplify, then one link, then "
                         "one set-feed"};
        reached = step;
    }
    return {};
}

Result<EditReport> applyOne(const Edit& edit, PathUnderEdit& state, const PathContext& context, Progress& progress) {
    EditReport report;
    report.edit = idOf(edit.parameters);
    report.pointsBefore = state.count();
    const Result<Deviation> deviation = std::visit(
        [&](const auto& parameters) { return apply(parameters, state, context, progress); }, edit.parameters);
    if (!deviation) return deviation.error();
    report.pointsAfter = state.count();
    report.largestDeviation = deviation->distance;
    report.worstPlace = deviation->place;
    return report;
}

} // namespace

Result<EvaluatedPath> evaluate(const std::string& name, const std::vector<Take>& takes, const std::vector<Edit>& edits,
                               const PathContext& context, Progress& progress) {
    if (Result<void> order = checkOrder(edits); !order) return order.error();
    Result<PathUnderEdit> state = strokesOf(takes, context);
    if (!state) return state.error();
    EvaluatedPath evaluated;
    double done = 0.0;
    for (const Edit& edit : edits) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, name, "", ""};
        progress.report(done / static_cast<double>(edits.size()));
        done += 1.0;
        if (!edit.enabled) continue;
        if (state->count() == 0) break;
        Result<EditReport> report = applyOne(edit, *state, context, progress);
        if (progress.cancelled()) return Error{ErrorCode::cancelled, name, "", ""};
        if (!report) return report.error();
        if (movesPath(edit.parameters)) evaluated.errorBudget += report->largestDeviation;
        evaluated.reports.push_back(std::move(*report));
    }
    evaluated.path.name = name;
    evaluated.path.toolId = context.tool.id;
    evaluated.path.spindleSpeed = state->spindleSpeed;
    evaluated.path.points = pointsOf(*state);
    if (evaluated.path.points.empty()) return Error{ErrorCode::pathEmpty, name, "", ""};
    progress.report(1.0);
    return evaluated;
}

} // namespace burin
