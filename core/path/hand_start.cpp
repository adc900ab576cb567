// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/hand_start.h"

#include "core/path/stroke_steps.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// The direction is that of the chord of so much of the motion: more than tremor and short moves, less than a corner.
constexpr double chord = 1.0; // mm
/// Edits that approximate stay well within this; what lies farther from the hand was moved on purpose.
constexpr double nearEnough = 0.5; // mm

std::optional<HandStart> startWith(const glm::dvec3& tip, const glm::dvec3& later) {
    const glm::dvec3 level(later.x - tip.x, later.y - tip.y, 0.0);
    const double length = glm::length(level);
    if (length < 0.1 * chord) return std::nullopt;
    return HandStart{tip, level / length};
}

const Take* takeOf(const PathStroke& stroke, const PathUnderEdit& state) {
    if (state.takes == nullptr) return nullptr;
    const auto found = std::ranges::find(*state.takes, stroke.take, [](const Take& take) { return take.info.id; });
    return found == state.takes->end() ? nullptr : &*found;
}

/// The first point of the stroke that is so far from its start, or the last one.
const StrokePoint& laterPoint(const PathStroke& stroke) {
    const glm::dvec3& tip = stroke.points.front().tip;
    const auto far = [&](const StrokePoint& point) { return glm::distance(point.tip, tip) >= chord; };
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

std::optional<HandStart> recordedStartOf(const PathStroke& stroke, const PathUnderEdit& state) {
    const Take* take = takeOf(stroke, state);
    if (take == nullptr) return std::nullopt;
    const auto sampleAt = [&](std::int64_t tick) {
        return std::ranges::lower_bound(take->samples, static_cast<std::uint64_t>(std::max<std::int64_t>(0, tick)), {},
                                        &Sample::tick);
    };
    auto at = sampleAt(stroke.points.front().sample);
    if (at == take->samples.end()) return std::nullopt;
    const glm::dvec3 tip = at->proxy.tip;
    const StrokePoint& later = laterPoint(stroke);
    const bool reversed = later.sample < stroke.points.front().sample;
    const auto there = sampleAt(later.sample);
    if (there == take->samples.end() || glm::distance(tip, stroke.points.front().tip) > nearEnough ||
        glm::distance(there->proxy.tip, later.tip) > nearEnough)
        return std::nullopt;
    while (glm::distance(at->proxy.tip, tip) < chord) {
        if (reversed ? at == take->samples.begin() : at + 1 == take->samples.end()) break;
        reversed ? --at : ++at;
    }
    return startWith(tip, at->proxy.tip);
}

} // namespace

std::optional<HandStart> startOf(const PathStroke& stroke, const PathUnderEdit& state) {
    if (stroke.points.size() < 2) return std::nullopt;
    if (const std::optional<HandStart> recorded = recordedStartOf(stroke, state)) return recorded;
    return ownStartOf(stroke);
}

} // namespace burin
