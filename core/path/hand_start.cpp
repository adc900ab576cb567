// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/hand_start.h"

#include "core/path/hand_trail.h"
#include "core/path/stroke_steps.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace burin {
namespace {

/// The direction is that of the chord over this length: longer than tremor and short moves, shorter than a corner.
constexpr double chord = 1.0; // mm
/// Edits that approximate stay well within this; a point farther from the hand was moved on purpose.
constexpr double nearEnough = 0.5; // mm

std::optional<HandStart> startWith(const glm::dvec3& tip, const glm::dvec3& later) {
    const glm::dvec3 level(later.x - tip.x, later.y - tip.y, 0.0);
    const double length = glm::length(level);
    if (length < 0.1 * chord) return std::nullopt;
    return HandStart{tip, level / length};
}

/// The first point of the stroke at least `chord` from its start, or the last one.
const StrokePoint& laterPoint(const PathStroke& stroke) {
    const glm::dvec3& tip = stroke.points.front().pose.tip;
    const auto far = [&](const StrokePoint& point) { return glm::distance(point.pose.tip, tip) >= chord; };
    const auto found = std::ranges::find_if(stroke.points, far);
    return found == stroke.points.end() ? stroke.points.back() : *found;
}

std::optional<HandStart> ownStartOf(const PathStroke& stroke) {
    const auto end = static_cast<std::size_t>(&laterPoint(stroke) - stroke.points.data());
    const std::vector<StrokeStep> steps = stepsOf(between(stroke, {0, 1.0}, {end, 1.0}), 0.25 * chord);
    const glm::dvec3& tip = steps.front().tip;
    const auto far = [&](const StrokeStep& step) { return glm::distance(step.tip, tip) >= chord; };
    const auto found = std::ranges::find_if(steps, far);
    return startWith(tip, found == steps.end() ? steps.back().tip : found->tip);
}

/// The position of the hand at a tick. @param next the first mark that is not before it
glm::dvec3 tipAt(std::span<const HandMark> marks, std::size_t next, std::int64_t tick) {
    const HandMark& behind = marks[next];
    if (next == 0 || behind.tick == tick) return behind.tip;
    const HandMark& before = marks[next - 1];
    const double share = static_cast<double>(tick - before.tick) / static_cast<double>(behind.tick - before.tick);
    return glm::mix(before.tip, behind.tip, share);
}

std::optional<HandStart> recordedStartOf(const PathStroke& stroke, const PathUnderEdit& state) {
    const std::span<const HandMark> marks = state.hand ? state.hand->of(stroke.source) : std::span<const HandMark>();
    const auto markAt = [&](std::int64_t tick) {
        return static_cast<std::size_t>(std::ranges::lower_bound(marks, tick, {}, &HandMark::tick) - marks.begin());
    };
    const StrokePoint &first = stroke.points.front(), &later = laterPoint(stroke);
    std::size_t at = markAt(first.sample);
    const std::size_t there = markAt(later.sample);
    if (at == marks.size() || there == marks.size()) return std::nullopt;
    const glm::dvec3 tip = tipAt(marks, at, first.sample);
    if (glm::distance(tip, first.pose.tip) > nearEnough ||
        glm::distance(tipAt(marks, there, later.sample), later.pose.tip) > nearEnough)
        return std::nullopt;
    const bool reversed = later.sample < first.sample;
    while (glm::distance(marks[at].tip, tip) < chord) {
        if (reversed ? at == 0 : at + 1 == marks.size()) break;
        reversed ? --at : ++at;
    }
    return startWith(tip, marks[at].tip);
}

} // namespace

std::optional<HandStart> startOf(const PathStroke& stroke, const PathUnderEdit& state) {
    if (stroke.points.size() < 2) return std::nullopt;
    if (const std::optional<HandStart> recorded = recordedStartOf(stroke, state)) return recorded;
    return ownStartOf(stroke);
}

} // namespace burin
