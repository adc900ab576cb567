// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

#include "core/base/parallel.h"
#include "core/path/back_steps.h"
#include "core/path/drilled_holes.h"
#include "core/path/entry_planner.h"
#include "core/path/linker.h"

#include <algorithm>

namespace burin {
namespace {

/// A height above the stock, the part, every tip, and all obstacles except those that are entirely above these.
double safeHeightOf(const Link& edit, const PathUnderEdit& state, const PathContext& context, const PartGuard& guard) {
    double height = std::max(context.stock.high.z, guard.top()) + edit.clearanceAbove;
    for (const PathStroke& stroke : state.strokes) {
        for (const StrokePoint& point : stroke.points) height = std::max(height, point.pose.tip.z);
    }
    const double working = height;
    for (const ObstacleSolid& obstacle : context.obstacles) {
        const Box box = obstacle.surface->bounds();
        if (obstacle.on && box.low.z < working)
            height = std::max(height, box.high.z + obstacle.margin + edit.clearanceAbove);
    }
    return height;
}

/// Strokes with the data needed to link them.
struct LinkTask {
    const Link& edit;
    const PartGuard& guard;
    const PathContext& context;
    double safeHeight; // mm
    const std::vector<PathStroke>& strokes;
    std::vector<StrokeAccess> accesses{};
    Deviation deviation{}; ///< by points that linking leaves out
};

/// @param watch null: shank and holder can touch nothing, or no stock is known
Result<void> linkAll(LinkTask& task, ShankWatch* watch, PathUnderEdit& state, Progress& progress) {
    LinkRoom room(task.edit, task.guard, task.context, task.safeHeight);
    const EntryPlanner planner(task.edit, room, task.guard, task.context, watch);
    Linker linker(room, task.guard, task.context, planner, watch);
    for (std::size_t i = 0; i < task.strokes.size(); ++i) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "path", "", ""};
        linker.add(task.strokes[i], task.accesses[i]);
    }
    linker.leave();
    state.points = std::move(linker.points);
    state.omissions = std::move(linker.omissions);
    state.entries = std::move(linker.entries);
    task.deviation.include(linker.leftOut);
    return {};
}

/// Links while watching the stock, for tools that go deeper than their flutes are long.
Result<void> linkWatched(LinkTask& task, PathUnderEdit& state, Progress& progress) {
    const auto inStock = [&](RunVolume& stock) -> Result<void> {
        ShankWatch watch(stock, task.context.tool.cutter);
        if (Result<void> done = linkAll(task, &watch, state, progress); !done) return done;
        if (watch.outOfMemory())
            return Error{ErrorCode::volumeOutOfMemory, std::to_string(stock.reservedBytes()), "", ""};
        return {};
    };
    return task.context.lendStock(inStock, progress);
}

bool goesDeep(const LinkTask& task) {
    double lowest = task.context.stock.high.z;
    for (const PathStroke& stroke : task.strokes)
        for (const StrokePoint& point : stroke.points) lowest = std::min(lowest, point.pose.tip.z);
    return lowest + task.context.tool.cutter.fluteLength < task.context.stock.high.z + 1.0;
}

/// Whether any stroke begins where there was stock.
bool entersStock(const LinkTask& task) {
    return std::ranges::any_of(task.strokes, [&](const PathStroke& stroke) {
        return std::ranges::any_of(
            stroke.points, [&](const StrokePoint& point) { return point.pose.tip.z < task.context.stock.high.z; });
    });
}

} // namespace

Result<Deviation> apply(const Link& edit, PathUnderEdit& state, const PathContext& context, Progress& progress) {
    const Result<PartGuard> guard = PartGuard::of(context);
    if (!guard) return guard.error();
    if (context.stock.empty()) return Error{ErrorCode::argumentInvalid, "stock", "", "links need the stock's box"};
    std::erase_if(state.strokes, [](const PathStroke& stroke) { return stroke.points.empty(); });
    const Deviation dropped = dropBackSteps(state, *guard, progress);
    if (edit.entry == Link::Entry::ramp) std::ranges::for_each(state.strokes, beginAtBottom);
    LinkTask task{edit, *guard, context, safeHeightOf(edit, state, context, *guard), state.strokes};
    task.deviation = dropped;
    task.accesses.resize(state.strokes.size());
    parallelFor(std::size_t{0}, task.accesses.size(), [&](std::size_t i) {
        if (!progress.cancelled()) task.accesses[i] = accessOf(state.strokes[i], *guard, task.safeHeight);
    });
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "path", "", ""};
    state.lengthBefore = 0.0;
    for (const PathStroke& stroke : state.strokes) state.lengthBefore += lengthOf(stroke);
    state.rampsIn = edit.entry == Link::Entry::ramp;
    const bool watched = context.lendStock && (goesDeep(task) || (state.rampsIn && entersStock(task)));
    const Result<void> strung = watched ? linkWatched(task, state, progress) : linkAll(task, nullptr, state, progress);
    if (!strung) return strung.error();
    if (context.tool.cutter.type == CutterType::drill) plungeAndReturn(state.points, edit.approach);
    state.strokes.clear();
    state.linked = true;
    return task.deviation;
}

} // namespace burin
