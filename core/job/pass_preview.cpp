// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/pass_preview.h"

#include "core/passes/plan_pass.h"
#include "core/passes/surface_pass.h"

#include <algorithm>

namespace burin {

namespace {

constexpr double rows = 20.0;     // shown by a preview across the part
constexpr double coarsest = 16.0; // so that the drawn lines still lie on the part
constexpr double ofLevels = 3.0;  // their number of loops is kept
constexpr double ofPencil = 2.0;  // coarser rasters would miss edges

/// @return 1: as fine as the pass itself
double coarsenessOf(const PassRequest& request, const MillingContext& milling) {
    switch (request.kind) {
    case PassKind::levels:
    case PassKind::pocket:
    case PassKind::profile:
    case PassKind::face:
        return ofLevels;
    case PassKind::pencil:
        return ofPencil;
    case PassKind::drill:
    case PassKind::thread:
    case PassKind::engrave:
        return 1.0;
    default:
        break;
    }
    const Result<double> step = stepOverOf(request, milling.tool.cutter);
    if (!step) return 1.0; // planning reports why
    const Box part = milling.partModel->box();
    glm::dvec3 size = part.empty() ? milling.setup.stock.size() : part.size();
    if (!request.area.empty()) size = glm::dvec3(boundsOf(request.area).high - boundsOf(request.area).low, size.z);
    const double across = request.kind == PassKind::waterline ? size.z : std::max(size.x, size.y);
    return std::clamp(across / (rows * *step), 1.0, coarsest);
}

bool isOfRows(PassKind kind) noexcept {
    return (kind >= PassKind::parallel && kind <= PassKind::scallop) || kind == PassKind::rest;
}

/// The time that strokes take, s; 0 if a feed is not known.
double durationOf(const PlannedPass& planned, const CuttingConditions& conditions) {
    double minutes = 0.0;
    for (std::size_t s = 0; s < planned.strokes.size(); ++s)
        for (std::size_t i = 1; i < planned.strokes[s].size(); ++i) {
            const double feed = plannedFeed(planned, s, i, conditions);
            if (!(feed > 0.0)) return 0.0;
            minutes += glm::distance(planned.strokes[s][i - 1], planned.strokes[s][i]) / feed;
        }
    return 60.0 * minutes;
}

} // namespace

Result<PassPreview> previewPass(const PassBasis& basis, const MillingContext& milling, const PassRequest& request,
                                Progress& progress) {
    const double coarseness = coarsenessOf(request, milling);
    Result<PlannedPass> planned = planOn(basis, milling, request, coarseness, progress);
    if (!planned) return std::move(planned).error();
    PassPreview preview;
    preview.every = isOfRows(request.kind) ? coarseness : 1.0;
    preview.length = preview.every * lengthOf(*planned);
    CuttingConditions conditions = milling.conditions;
    if (request.kind == PassKind::drill) conditions.feed = conditions.plungeFeed;
    preview.duration = preview.every * durationOf(*planned, conditions);
    preview.leftOut = preview.every * planned->leftOut;
    preview.inTheWay = preview.every * planned->inTheWay;
    preview.leftToHand = preview.every * planned->leftToHand;
    preview.unreachedHoles = planned->unreachedHoles;
    preview.strokes = std::move(planned->strokes);
    return preview;
}

} // namespace burin
