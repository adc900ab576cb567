// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/material_feed.h"

#include "core/base/numbers.h"
#include "core/base/units.h"
#include "core/geometry/arc.h"
#include "core/path/hand_interval.h"
#include "core/path/machine_check.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// On descents steeper than 45° a tool cuts with its end, for which the plunge feed is intended.
bool goesDownSteeply(const glm::dvec3& from, const glm::dvec3& to) noexcept {
    return from.z - to.z > std::hypot(to.x - from.x, to.y - from.y);
}

/// Whether any part of a move does so; an arc is checked in chords of 5° at most.
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

/// Ramps cut like a slot, though less deep: half of the feed, and no faster downwards than a plunge.
double rampFeed(const glm::dvec3& from, const PathPoint& to, double cutting, double plunging) {
    const double down = from.z - to.pose.tip.z, fastest = std::max(plunging, 0.5 * cutting);
    return down > 0.0 ? std::min(fastest, plunging * lengthOf(from, to) / down) : fastest;
}

/// The conditions of the tables with the user's factors, within the limits of tool and machine.
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

/// Gives moves the feeds and speeds that their program states, within the limits of tool and machine.
class StatedMoves {
public:
    StatedMoves(const SetFeed& edit, PathUnderEdit& state, const PathContext& context)
        : edit_(edit)
        , state_(state)
        , context_(context)
        , speeds_(state.points.size(), 0.0)
        , stated_(state.points.size(), false) {}

    /// Whether every move that a source has comes from a program.
    bool all() const {
        return std::ranges::all_of(state_.points, [&](const PathPoint& point) {
            return point.kind == MoveKind::rapid || !hasMoment(point) || state_.stated->holds(point.source);
        });
    }

    void apply() {
        Moment from{};
        for (std::size_t i = 0; i < state_.points.size(); ++i) {
            PathPoint& point = state_.points[i];
            const Moment to = momentOf(point);
            if (point.kind != MoveKind::rapid) {
                if (const auto stated = state_.stated->between(from, to)) {
                    take(point, *stated, speeds_[i]);
                    stated_[i] = true;
                } else if (hasMoment(point) && !state_.stated->holds(point.source))
                    speeds_[i] = speedOf(point, state_.spindleSpeed);
            }
            from = to;
        }
        spreadSpeeds();
        limitLinks();
    }

private:
    void take(PathPoint& point, const StatedFeed& stated, double& speed) const {
        const bool turns = stated.spindleSpeed > 0.0;
        double fastest = turns ? stated.spindleSpeed * edit_.speedFactor : speedOf(point, state_.spindleSpeed);
        for (const double limit : {context_.machine.maximumSpindleSpeed, context_.tool.maximumSpindleSpeed})
            if (limit > 0.0) fastest = std::min(fastest, limit);
        speed = fastest;
        // The chip load is kept if the spindle cannot turn as fast.
        const double share = turns ? fastest / stated.spindleSpeed : edit_.speedFactor;
        point.feed = stated.feed * share * edit_.feedFactor;
        if (context_.machine.maximumFeed > 0.0) point.feed = std::min(point.feed, context_.machine.maximumFeed);
    }

    /// Moves made by links get the speed of the move that they lead to, or, behind the last, of the one that they come
    /// from.
    void spreadSpeeds() {
        double next = 0.0;
        const auto fill = [&](std::size_t i) {
            if (state_.points[i].kind == MoveKind::rapid) return;
            if (!(speeds_[i] > 0.0)) speeds_[i] = next;
            next = speeds_[i];
        };
        for (std::size_t i = speeds_.size(); i-- > 0;) fill(i);
        for (std::size_t i = 0; i < speeds_.size(); ++i) fill(i);
        const auto first = std::ranges::find_if(speeds_, [](double speed) { return speed > 0.0; });
        if (first == speeds_.end()) return;
        state_.spindleSpeed = *first;
        for (std::size_t i = 0; i < speeds_.size(); ++i)
            state_.points[i].spindleSpeed = speeds_[i] != state_.spindleSpeed ? speeds_[i] : 0.0;
    }

    /// Nor are links faster than these moves: a user who chose a careful feed did not mean to approach at that of a
    /// table.
    void limitLinks() {
        double next = 0.0;
        const auto limit = [&](std::size_t i) {
            PathPoint& point = state_.points[i];
            if (point.kind == MoveKind::rapid) return;
            if (!stated_[i] && next > 0.0 && (!hasMoment(point) || state_.stated->holds(point.source)))
                point.feed = std::min(point.feed, next);
            if (stated_[i] || hasMoment(point)) next = stated_[i] ? point.feed : 0.0;
        };
        for (std::size_t i = stated_.size(); i-- > 0;) limit(i);
        next = 0.0;
        for (std::size_t i = 0; i < stated_.size(); ++i) limit(i);
    }

    const SetFeed& edit_;
    PathUnderEdit& state_;
    const PathContext& context_;
    std::vector<double> speeds_; ///< 1/min per point; 0: not known yet, and for rapids
    std::vector<bool> stated_;   ///< per point: its program states its feed
};

/// Gives moves the coolant that their program states. Moves made by links get that of the move that they lead to, or,
/// behind the last, of the one that they come from; those of other sources keep that of the path.
/// Errors: notSupported (a coolant that the machine lacks).
Result<void> takeStatedCoolants(PathUnderEdit& state, const PathContext& context) {
    std::vector<std::optional<Coolant>> coolants(state.points.size());
    Moment from{};
    for (std::size_t i = 0; i < state.points.size(); ++i) {
        const PathPoint& point = state.points[i];
        const Moment to = momentOf(point);
        if (point.kind != MoveKind::rapid) {
            const auto stated = state.stated->between(from, to);
            if (stated && stated->coolant)
                coolants[i] = stated->coolant;
            else if (hasMoment(point) && !state.stated->holds(point.source))
                coolants[i] = state.coolant;
        }
        from = to;
    }
    std::optional<Coolant> next;
    const auto fill = [&](std::size_t i) {
        if (state.points[i].kind == MoveKind::rapid) return;
        if (!coolants[i]) coolants[i] = next;
        next = coolants[i];
    };
    for (std::size_t i = coolants.size(); i-- > 0;) fill(i);
    for (std::size_t i = 0; i < coolants.size(); ++i) fill(i);
    const auto first = std::ranges::find_if(coolants, [](const auto& coolant) { return coolant.has_value(); });
    if (first == coolants.end()) return {};
    state.coolant = **first;
    for (std::size_t i = 0; i < coolants.size(); ++i) {
        if (!coolants[i]) continue;
        if (Result<void> has = checkCoolant(*coolants[i], context.machine); !has) return has;
        if (*coolants[i] != state.coolant) state.points[i].coolant = coolants[i];
    }
    return {};
}

Result<Coolant> wantedCoolant(SetFeed::Cooling cooling, const PathContext& context) {
    if (cooling == SetFeed::Cooling::advised || cooling == SetFeed::Cooling::program)
        return context.machine.has(context.advisedCoolant) ? context.advisedCoolant : Coolant::off;
    const auto wanted = static_cast<Coolant>(static_cast<int>(cooling) - static_cast<int>(SetFeed::Cooling::off));
    if (Result<void> has = checkCoolant(wanted, context.machine); !has) return has.error();
    return wanted;
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
    const bool stated = edit.feeds == SetFeed::Feeds::program && state.stated && !state.stated->empty();
    const bool byMaterial = !context.materialConditions.empty() && context.lendStock &&
                            !(stated && StatedMoves(edit, state, context).all());
    if (byMaterial) {
        std::vector<CuttingConditions> each;
        for (const CuttingConditions& material : context.materialConditions)
            each.push_back(wantedConditions(material, edit, context));
        CuttingConditions given = conditions;
        given.feed = cutting;
        given.plungeFeed = plunging;
        if (Result<void> done = feedByMaterial(state, context, each, given, edit.spindle, progress); !done)
            return std::move(done).error();
    }
    if (stated) StatedMoves(edit, state, context).apply();
    if (edit.cooling == SetFeed::Cooling::program && state.stated && !state.stated->empty())
        if (Result<void> done = takeStatedCoolants(state, context); !done) return std::move(done).error();
    return Deviation{};
}

} // namespace burin
