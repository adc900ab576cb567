// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/material_feed.h"

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
    if (!to.arc) return goesDownSteeply(from, to.pose.tip);
    constexpr double finestTurn = 5.0 * pi / 180.0;
    const Arc arc{from, to.pose.tip, to.arc->centre, to.arc->axis, to.arc->clockwise};
    const ArcTurn turn = turnOf(arc);
    const int steps = static_cast<int>(std::ceil(std::abs(turn.sweep) / finestTurn));
    for (int i = 0; i < steps; ++i)
        if (goesDownSteeply(placeOn(arc, turn, static_cast<double>(i) / steps),
                            placeOn(arc, turn, static_cast<double>(i + 1) / steps)))
            return true;
    return false;
}

/// Ramps cut as a slot does, though less deep: half of the feed, and no faster down than a plunge.
double rampFeed(const glm::dvec3& from, const PathPoint& to, double cutting, double plunging) {
    const double down = from.z - to.pose.tip.z, fastest = std::max(plunging, 0.5 * cutting);
    return down > 0.0 ? std::min(fastest, plunging * lengthOf(from, to) / down) : fastest;
}

/// The tables' conditions as the user wants them, within what tool and machine can do.
CuttingConditions wantedConditions(CuttingConditions wanted, const SetFeed& edit, const PathContext& context) {
    double fastest = wanted.spindleSpeed * edit.speedFactor;
    for (const double limit : {context.machine.maximumSpindleSpeed, context.tool.maximumSpindleSpeed})
        if (limit > 0.0) fastest = std::min(fastest, limit);
    const double factor = wanted.spindleSpeed > 0.0 ? fastest / wanted.spindleSpeed : 1.0;
    wanted.spindleSpeed *= factor;
    wanted.surfaceSpeed *= factor;
    wanted.feed *= factor * edit.feedFactor;
    wanted.plungeFeed *= factor * edit.feedFactor;
    return wanted;
}

Result<Coolant> wantedCoolant(SetFeed::Cooling cooling, const PathContext& context) {
    if (cooling == SetFeed::Cooling::advised)
        return context.machine.has(context.advisedCoolant) ? context.advisedCoolant : Coolant::off;
    const auto wanted = static_cast<Coolant>(static_cast<int>(cooling) - static_cast<int>(SetFeed::Cooling::off));
    if (context.machine.has(wanted)) return wanted;
    return Error{ErrorCode::notSupported, std::string(idOf(wanted)) + " coolant for " + context.machine.name, "", ""};
}

} // namespace

Result<Deviation> apply(const SetFeed& edit, PathUnderEdit& state, const PathContext& context, Progress& progress) {
    const CuttingConditions conditions = wantedConditions(context.conditions, edit, context);
    const Result<Coolant> coolant = wantedCoolant(edit.cooling, context);
    if (!coolant) return coolant.error();
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
        const bool steep = i > 0 && goesDownSteeply(state.points[i - 1].pose.tip, point);
        if (point.kind == MoveKind::rapid)
            point.feed = 0.0;
        else if (i > 0 && state.rampsIn && point.kind == MoveKind::plunge && !steep)
            point.feed = rampFeed(state.points[i - 1].pose.tip, point, cutting, plunging);
        else
            point.feed = point.kind == MoveKind::plunge || steep ? plunging : cutting;
    }
    state.spindleSpeed = conditions.spindleSpeed;
    state.coolant = *coolant;
    if (context.materialConditions.empty() || !context.lendStock) return Deviation{};
    std::vector<CuttingConditions> each;
    for (const CuttingConditions& material : context.materialConditions)
        each.push_back(wantedConditions(material, edit, context));
    CuttingConditions given = conditions;
    given.feed = cutting;
    given.plungeFeed = plunging;
    if (Result<void> done = feedByMaterial(state, context, each, given, edit.spindle, progress); !done)
        return std::move(done).error();
    return Deviation{};
}

} // namespace burin
