// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"
#include "core/path/lowering.h"
#include "core/path/polyline.h"

namespace burin {
namespace {

constexpr double layThinning = 0.002; // mm, of points that carry no shape, before they are projected onto the part

} // namespace

Result<Deviation> apply(const LayOnPart& edit, PathUnderEdit& state, const PathContext& context, Progress& progress) {
    const Result<PartGuard> guard = PartGuard::of(context);
    if (!guard) return guard.error();
    const HoldOut hold;
    const Lowering lowering(*guard, edit.allowance + hold.clearance, context.stock.low.z, edit.along);
    std::vector<PathStroke> laid;
    for (PathStroke& stroke : state.strokes) {
        if (progress.cancelled()) break;
        keepOnly(stroke.points,
                 simplifyInGroups(
                     stroke.points, layThinning, [](const glm::dvec3&, const glm::dvec3&) { return true; }, progress));
        stroke.allowance = edit.allowance;
        for (PathStroke& part : lowered(stroke, lowering, edit.sampling, progress)) laid.push_back(std::move(part));
    }
    state.strokes = std::move(laid);
    return apply(hold, state, context, progress);
}

} // namespace burin
