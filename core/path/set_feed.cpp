// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

#include "core/base/numbers.h"
#include "core/base/units.h"
#include "core/geometry/arc.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Steeper than 45° downwards a tool cuts with its end, which is what the plunge feed is for.
bool goesDownSteeply(const glm::dvec3& from, const glm::dvec3& to) noexcept {
    return from.z - to.z > std::hypot(to.x - from.x, to.y - from.y);
}

/// Whether a move does so anywhere; of an arc, chords of 5° at most are asked.
bool goesDownSteeply(const glm::dvec3& from, const PathPoint& to) {
    if (!to.arc) return goesDownSteeply(from, to.tip);
    constexpr double finestTurn = 5.0 * pi / 180.0;
    const Arc arc{from, to.tip, to.arc->centre, to.arc->axis, to.arc->clockwise};
    const ArcTurn turn = turnOf(arc);
    const int steps = static_cast<int>(std::ceil(std::abs(turn.sweep) / finestTurn));
    for (int i = 0; i < steps; ++i)
        if (goesDownSteeply(placeOn(arc, turn, static_cast<double>(i) / steps),
                            placeOn(arc, turn, static_cast<double>(i + 1) / steps)))
            return true;
    return false;
}

} // namespace

Result<Deviation> apply(const SetFeed&, PathUnderEdit& state, const PathContext& context, Progress&) {
    const CuttingConditions& conditions = context.conditions;
    for (const auto& [name, value] :
         {std::pair{"feed", conditions.feed}, std::pair{"plunge feed", conditions.plungeFeed},
          std::pair{"spindle speed", conditions.spindleSpeed}}) {
        if (!(value > 0.0) || !std::isfinite(value))
            return Error{ErrorCode::argumentInvalid, name, formatShortest(value), "above 0"};
    }
    const double limit = context.machine.maximumFeed > 0.0 ? context.machine.maximumFeed : conditions.feed;
    const double cutting = std::min(conditions.feed, limit), plunging = std::min(conditions.plungeFeed, cutting);
    state.points = pointsOf(state);
    state.linked = true;
    state.strokes.clear();
    for (std::size_t i = 0; i < state.points.size(); ++i) {
        PathPoint& point = state.points[i];
        const bool steep = i > 0 && goesDownSteeply(state.points[i - 1].tip, point);
        if (point.kind == MoveKind::rapid)
            point.feed = 0.0;
        else
            point.feed = point.kind == MoveKind::plunge || steep ? plunging : cutting;
    }
    state.spindleSpeed = conditions.spindleSpeed;
    return Deviation{};
}

} // namespace burin
