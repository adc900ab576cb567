// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"
#include "core/passes/crease_lines.h"
#include "core/passes/surface_pass.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double coarsestRaster = 0.5; // mm
constexpr double mostSquares = 1500.0; // along a side of the raster, to limit its memory
constexpr double shortest = 2.0;       // squares of the raster: shorter lines are not edges

/// Orders the creases, each from the end that is nearer to where the last one ended.
std::vector<TipLine> inOrder(std::vector<TipLine> lines) {
    std::vector<TipLine> ordered;
    glm::dvec3 tip(0.0);
    while (!lines.empty()) {
        std::size_t next = 0;
        double least = 1e300;
        bool fromEnd = false;
        for (std::size_t i = 0; i < lines.size(); ++i)
            for (const bool end : {false, true}) {
                const double way = ordered.empty() ? static_cast<double>(i)
                                                   : glm::distance(end ? lines[i].back() : lines[i].front(), tip);
                if (!(way < least)) continue;
                least = way;
                next = i;
                fromEnd = end;
            }
        if (fromEnd) std::ranges::reverse(lines[next]);
        tip = lines[next].back();
        ordered.push_back(std::move(lines[next]));
        lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(next));
    }
    return ordered;
}

/// The request limited by its lines, if it has any: only edges within one tool diameter of them.
PassRequest ledBy(PassRequest request, double width) {
    if (request.lines.empty()) return request;
    PlanRegion beside;
    for (const PassLine& line : request.lines)
        beside = joined(beside, brushed(std::vector<glm::dvec2>(line.begin(), line.end()), width));
    request.area = request.area.empty() ? beside : without(beside, without(beside, request.area));
    if (request.area.empty()) request.area = rectangle(glm::dvec2(0.0), glm::dvec2(1e-3)); // the areas do not intersect
    return request;
}

} // namespace

Result<PlannedPass> planPencil(const PassRequest& asked, const PassGround& ground, Progress& progress) {
    const PassRequest request = ledBy(asked, ground.tool.cutter.diameter);
    if (ground.part.bounds().empty())
        return Error{ErrorCode::argumentInvalid, "pass", std::string(rowOf(request.kind).id),
                     "a part with edges to follow; there is none"};
    const SurfaceTrace trace(request, ground);
    const PlanBounds bounds = trace.bounds();
    const double largest = std::max(bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y);
    const double finest = std::min(coarsestRaster, ground.tool.cutter.radius() / 6.0);
    const double raster = std::max(ground.coarseness * finest, largest / mostSquares);
    std::vector<TipLine> creases = creaseLines(trace, raster, progress);
    std::erase_if(creases, [&](const TipLine& line) { return lengthOf(line) < shortest * raster; });
    std::vector<std::vector<TipLine>> intervals(creases.size());
    std::vector<double> leftOut(creases.size(), 0.0);
    parallelFor(std::size_t{0}, creases.size(), [&](std::size_t i) {
        if (!progress.cancelled()) intervals[i] = trace.intervalsOf(creases[i], leftOut[i]);
    });
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "pass", "", ""};
    PlannedPass planned;
    for (const double one : leftOut) planned.leftOut += one;
    std::vector<TipLine> lines;
    for (const std::vector<TipLine>& line : intervals) lines.insert(lines.end(), line.begin(), line.end());
    for (const TipLine& line : inOrder(std::move(lines))) planned.strokes.push_back(straightened(line));
    return planned;
}

} // namespace burin
