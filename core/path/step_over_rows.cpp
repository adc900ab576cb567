// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"
#include "core/path/apply.h"
#include "core/path/plan_offset.h"

#include <algorithm>

namespace burin {
namespace {

/// Returns the strokes that form the guide and removes them from the path.
std::vector<PathStroke> takeGuide(const StepOverRows& edit, PathUnderEdit& state, const PathContext& context) {
    std::vector<PathStroke> guide, others;
    if (!edit.guide.empty()) {
        PathStroke drawn{0, edit.allowance, edit.allowance, context.tickPeriod, {}};
        for (const glm::dvec3& place : edit.guide) {
            StrokePoint point;
            point.pose.tip = place;
            point.sample = -1;
            drawn.points.push_back(point);
        }
        guide.push_back(std::move(drawn));
        return guide;
    }
    for (PathStroke& stroke : state.strokes)
        (touches(edit.interval, stroke) ? guide : others).push_back(std::move(stroke));
    state.strokes = std::move(others);
    return guide;
}

/// From the outermost row on the right to the one on the left, every other one backwards.
std::vector<PathStroke> rowsBeside(const PathStroke& guide, const StepOverRows& edit, const Progress& progress) {
    const auto left = static_cast<int>(edit.left), right = static_cast<int>(edit.right);
    std::vector<std::vector<std::vector<StrokePoint>>> rows(static_cast<std::size_t>(left + right + 1));
    parallelFor(std::size_t{0}, rows.size(), [&](std::size_t i) {
        if (!progress.cancelled())
            rows[i] = offsetInPlan(guide.points, (static_cast<double>(i) - right) * edit.stepOver);
    });
    std::vector<PathStroke> strokes;
    bool back = false;
    for (std::vector<std::vector<StrokePoint>>& pieces : rows) {
        if (back) std::ranges::reverse(pieces);
        for (std::vector<StrokePoint>& points : pieces) {
            if (back) std::ranges::reverse(points);
            strokes.push_back({guide.source, guide.allowance, guide.required, guide.tickPeriod, std::move(points)});
        }
        back = !back;
    }
    return strokes;
}

} // namespace

Result<Deviation> apply(const StepOverRows& edit, PathUnderEdit& state, const PathContext& context,
                        Progress& progress) {
    const std::vector<PathStroke> guides = takeGuide(edit, state, context);
    if (guides.empty())
        return Error{ErrorCode::argumentInvalid, "stretch", "take " + std::to_string(edit.interval.source),
                     "moments that the path still has"};
    PathUnderEdit rows;
    for (const PathStroke& guide : guides)
        for (PathStroke& row : rowsBeside(guide, edit, progress)) rows.strokes.push_back(std::move(row));
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "path", "", ""};
    LayOnPart onto;
    onto.allowance = edit.allowance;
    const Result<Deviation> laid = apply(onto, rows, context, progress);
    if (!laid) return laid.error();
    const Result<Deviation> held = apply(HoldOut{}, state, context, progress); // for the other strokes
    if (!held) return held.error();
    for (PathStroke& row : rows.strokes) state.strokes.push_back(std::move(row));
    Deviation deviation = *held;
    deviation.include(*laid);
    return deviation;
}

} // namespace burin
