// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/numbers.h"
#include "core/path/apply.h"
#include "core/path/hand_interval.h"
#include "core/path/machine_check.h"
#include "core/path/moves_within.h"

#include <algorithm>
#include <optional>

namespace burin {
namespace {

/// Returns, for each point, whether the move that ends there lies between two rapids between which the path passes a
/// moment.
std::vector<bool> strokesThrough(const std::vector<PathPoint>& points, const SourceInterval& moment) {
    std::vector<bool> within(points.size(), false);
    for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
        end = begin + 1;
        if (points[begin].kind == MoveKind::rapid) continue;
        while (end < points.size() && points[end].kind != MoveKind::rapid) ++end;
        bool leads = false;
        for (std::size_t i = begin; i < end && !leads; ++i)
            leads = leadsThrough(i > 0 ? momentOf(points[i - 1]) : Moment{}, momentOf(points[i]), moment);
        std::fill(within.begin() + static_cast<std::ptrdiff_t>(begin),
                  within.begin() + static_cast<std::ptrdiff_t>(end), leads);
    }
    return within;
}

Result<void> checkSpeed(double speed, const PathContext& context) {
    if (context.machine.maximumSpindleSpeed > 0.0)
        if (Result<void> range = checkSpindleSpeed(speed, context.machine); !range) return range;
    const double most = context.tool.maximumSpindleSpeed;
    if (most > 0.0 && speed > most)
        return Error{ErrorCode::argumentInvalid, "spindle speed", formatFixed(speed, 0) + " 1/min",
                     "at most " + formatFixed(most, 0) + " 1/min, the limit of the tool " + context.tool.name};
    return {};
}

} // namespace

Result<Deviation> apply(const SpindleAndCoolant& edit, PathUnderEdit& state, const PathContext& context, Progress&) {
    using Cooling = SpindleAndCoolant::Cooling;
    if (!(state.spindleSpeed > 0.0))
        return Error{ErrorCode::argumentInvalid, "edits", "section", "set-feed, then section"};
    const bool turns = edit.speed > 0.0 || edit.factor != 1.0;
    std::optional<Coolant> coolant;
    if (edit.cooling != Cooling::kept)
        coolant = static_cast<Coolant>(static_cast<int>(edit.cooling) - static_cast<int>(Cooling::off));
    if (coolant)
        if (Result<void> has = checkCoolant(*coolant, context.machine); !has) return has.error();
    if (!turns && !coolant) return Deviation{};
    const bool single = edit.interval.source != 0 && edit.interval.first == edit.interval.last;
    if (!single) state.points = dividedAt(state.points, edit.interval);
    const std::vector<bool> within =
        single ? strokesThrough(state.points, edit.interval) : movesWithin(state.points, edit.interval);
    for (std::size_t i = 0; i < state.points.size(); ++i) {
        PathPoint& point = state.points[i];
        if (point.kind == MoveKind::rapid || !within[i]) continue;
        if (coolant) point.coolant = coolant;
        if (!turns) continue;
        point.spindleSpeed = edit.factor * (edit.speed > 0.0 ? edit.speed : speedOf(point, state.spindleSpeed));
        if (Result<void> speed = checkSpeed(point.spindleSpeed, context); !speed) return speed.error();
    }
    return Deviation{};
}

} // namespace burin
