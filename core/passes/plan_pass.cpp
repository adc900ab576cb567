// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/plan_pass.h"

#include "core/geometry/upright.h"
#include "core/passes/drill_pass.h"
#include "core/passes/hand_finish.h"
#include "core/passes/keep_clear.h"
#include "core/passes/level_pass.h"
#include "core/passes/milling_plan.h"
#include "core/passes/surface_pass.h"
#include "core/passes/thread_pass.h"

#include <algorithm>

namespace burin {

namespace {

/// Errors: notSupported.
Result<void> checkTool(PassKind kind, const Tool& tool) {
    if (Result<void> turns = checkTurns(tool.cutter, "a computed pass with a tool that doesn't turn"); !turns)
        return turns;
    const bool drills = tool.cutter.type == CutterType::drill;
    const auto needs = [](const char* other) {
        return Error{ErrorCode::notSupported, "this pass with this kind of tool", other, {}};
    };
    if (kind == PassKind::drill) return drills ? Result<void>() : needs("a drill");
    if (kind == PassKind::thread) return drills ? needs("a thread mill") : Result<void>();
    return drills ? needs("a tool that cuts sideways and is nowhere wider below than above") : checkPlannable(tool);
}

} // namespace

bool mayPlan(PassKind kind, const Tool& tool) {
    // What is wider below than above mills threads, if anything.
    return checkTool(kind, tool) && (kind != PassKind::thread || !checkPlannable(tool));
}

bool needsField(const Tool& tool) {
    return !mayPlan(PassKind::drill, tool) && !mayPlan(PassKind::thread, tool);
}

Result<void> checkPass(const PassRequest& request, const Tool& tool) {
    if (Result<void> valid = validate(request); !valid) return valid;
    return checkTool(request.kind, tool);
}

Result<PlannedPass> planPass(const PassRequest& request, const PassGround& ground, Progress& progress) {
    if (Result<void> good = checkPass(request, ground.tool); !good) return std::move(good).error();
    Result<PlannedPass> planned = [&] {
        switch (request.kind) {
        case PassKind::levels:
        case PassKind::pocket:
        case PassKind::profile:
        case PassKind::face:
            return planLevels(request, ground, progress);
        case PassKind::waterline:
            return planWaterlines(request, ground, progress);
        case PassKind::pencil:
            return planPencil(request, ground, progress);
        case PassKind::rest:
            return planRest(request, ground, progress);
        case PassKind::engrave:
            return planEngraving(request, ground, progress);
        case PassKind::drill:
            return planDrilling(request, ground, progress);
        case PassKind::thread:
            return planThreads(request, ground, progress);
        case PassKind::parallel:
        case PassKind::radial:
        case PassKind::spiral:
        case PassKind::flow:
        case PassKind::scallop:
            break;
        }
        return planRows(request, ground, progress);
    }();
    if (planned) heedHandStrokes(*planned, request, ground, progress);
    if (planned) keepClear(*planned, pieces(ground.tool.cutter), ground.obstacles, progress);
    if (planned && progress.cancelled()) return Error{ErrorCode::cancelled, "pass", "", ""};
    if (planned) std::erase_if(planned->strokes, [](const TipLine& line) { return line.size() < 2; });
    return planned;
}

double lengthOf(const PlannedPass& planned) noexcept {
    double length = 0.0;
    for (const TipLine& line : planned.strokes) length += lengthOf(line);
    return length;
}

GeneratedMoves movesOf(const PlannedPass& planned, GeneratedInfo info) {
    GeneratedMoves moves{std::move(info), {}};
    std::int64_t moment = 0;
    for (const TipLine& line : planned.strokes) {
        std::vector<GeneratedPoint>& stroke = moves.strokes.emplace_back();
        stroke.reserve(line.size());
        for (const glm::dvec3& tip : line) stroke.push_back({{tip, uprightAxis}, moment++, true, true});
    }
    moves.info.pointCount = static_cast<std::uint64_t>(moment);
    return moves;
}

} // namespace burin
