// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/linker.h"

#include "core/path/turn_room.h"

#include <algorithm>

namespace burin {
namespace {

OmissionReason reasonOf(ToolSection touching) {
    return touching == ToolSection::shank ? OmissionReason::shank : OmissionReason::holder;
}

} // namespace

/// Whether shank or holder come down to where stock may remain.
bool Linker::mayTouch(const PathStroke& stroke) const {
    return watch_ != nullptr && std::ranges::any_of(stroke.points, [&](const StrokePoint& point) {
               return point.pose.tip.z + watch_->lowestGuard() < stockTop_;
           });
}

/// Appends a piece as far as it is clear; the next one begins where the tool is clear again over a sufficient length.
void Linker::addWatched(const PathStroke& stroke, const StrokeAccess& access) {
    const std::vector<StrokeStep> steps = stepsOf(stroke, watch_->step());
    const std::size_t last = steps.size() - 1;
    std::optional<std::size_t> from = 0;
    while (from) {
        const std::span<const StrokeStep> rest = std::span(steps).subspan(*from);
        const PathStroke* left = &stroke;
        StrokeAccess entry = access;
        if (*from > 0) {
            left = &pieces_.emplace_back(between(stroke, steps[*from].position, steps[last].position));
            entry = accessOf(*left, guard_, room_.safeHeight());
        }
        if (!entry.found) {
            leaveOut(*left, OmissionReason::access);
            return;
        }
        const std::optional<Piece> begun = begin(*left, entry);
        if (!begun) {
            leaveOut(*left, OmissionReason::plunge);
            return;
        }
        const Piece& piece = *begun;
        watch_->keep();
        const Rehearsal rehearsal = rehearse(piece, rest);
        if (!rehearsal.touching) {
            rehearsed_ = true;
            append(piece);
            rehearsed_ = false;
            return;
        }
        const std::size_t made = *from + appendUntilContact(stroke, piece, rest, rehearsal);
        from = clearFrom(steps, *from + rehearsal.reached + 1);
        leaveOut(between(stroke, steps[made].position, steps[from.value_or(last)].position),
                 reasonOf(*rehearsal.touching));
    }
}

/// @return the last step that was made; 0: nothing was worth making, and the stock is unchanged
std::size_t Linker::appendUntilContact(const PathStroke& whole, const Piece& piece, std::span<const StrokeStep> steps,
                                       const Rehearsal& rehearsal) {
    const StrokeStep &first = steps.front(), &last = steps[rehearsal.reached];
    if (last.at - first.at >= shortestKept_) {
        Piece made = piece;
        PathStroke part = between(whole, first.position, last.position);
        Deviation known; // counted when the piece was begun
        if (piece.longer) part = withLongStart(part, guard_, known).value_or(part);
        made.stroke = &pieces_.emplace_back(std::move(part));
        made.access = accessOf(*made.stroke, guard_, room_.safeHeight());
        if (piece.entry) made.access.entry = piece.entry->point;
        if (made.access.found && made.access.entry == piece.access.entry &&
            made.access.entry < made.stroke->points.size()) {
            rehearsed_ = true;
            append(made);
            rehearsed_ = false;
            return rehearsal.reached;
        }
    }
    watch_->goBack();
    return 0;
}

/// Simulates a piece in the stock only, until shank or holder would touch something.
Linker::Rehearsal Linker::rehearse(const Piece& piece, std::span<const StrokeStep> steps) {
    Rehearsal rehearsal;
    rehearsal.touching = rehearseEntry(piece);
    for (std::size_t i = 1; i < steps.size() && !rehearsal.touching; ++i) {
        rehearsal.touching = watch_->contactAt(steps[i].tip);
        if (rehearsal.touching) break;
        watch_->cut(steps[i - 1].tip, steps[i].tip);
        rehearsal.reached = i;
    }
    return rehearsal;
}

/// The same for the motion to the piece's first point.
std::optional<ToolSection> Linker::rehearseEntry(const Piece& piece) {
    const PathStroke& stroke = *piece.stroke;
    if (piece.joined) return watch_->cutClear(points.back().pose.tip, stroke.points.front().pose.tip);
    PathStroke way;
    way.points = piece.way;
    glm::dvec3 at(way.points.front().pose.tip.x, way.points.front().pose.tip.y, room_.safeHeight());
    for (const StrokeStep& step : stepsOf(way, watch_->step())) {
        if (const auto touching = watch_->cutClear(at, step.tip)) return touching;
        at = step.tip;
    }
    if (piece.access.entry == 0) return std::nullopt;
    PathStroke back = reversed(between(stroke, {0, 1.0}, {piece.access.entry, 1.0}));
    if (const std::optional<glm::dvec3> beyond = turnAt(stroke, 0, 1)) {
        const StrokePoint start = back.points.back();
        for (const glm::dvec3& place : {*beyond, start.pose.tip}) {
            back.points.push_back(start);
            back.points.back().pose.tip = place;
            back.points.back().arc.reset();
        }
    }
    for (const StrokeStep& step : stepsOf(back, watch_->step())) {
        if (const auto touching = watch_->cutClear(at, step.tip)) return touching;
        at = step.tip;
    }
    return std::nullopt;
}

/// The first step from which the tool is clear in the remaining stock, over the least length of a piece.
std::optional<std::size_t> Linker::clearFrom(const std::vector<StrokeStep>& steps, std::size_t first) {
    std::optional<std::size_t> start;
    for (std::size_t i = first; i < steps.size(); ++i) {
        if (watch_->contactAt(steps[i].tip)) {
            start.reset();
            continue;
        }
        if (!start) start = i;
        if (steps[i].at - steps[*start].at >= shortestKept_) return start;
    }
    return std::nullopt;
}

void Linker::leaveOut(const PathStroke& part, OmissionReason reason) {
    omissions.push_back(omissionOf(part, reason));
    mustLift_ = true;
}

} // namespace burin
