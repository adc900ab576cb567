// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/fixture_fit.h"

#include "core/setup/fixture_solid.h"
#include "core/setup/setup.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

constexpr double touching = 1e-6;             // mm, of rounding
constexpr double uprightCosine = 1.0 - 1e-12; // of the axis of a cylinder

/// How far one interval has to move to get out of another one.
double overlap(double low, double high, double otherLow, double otherHigh) noexcept {
    return std::min(high - otherLow, otherHigh - low);
}

/// The least over the axes that may separate a turned box from an upright one.
double boxDepth(const Placement& placement, const Box& box, const Box& stock) {
    const glm::dvec2 x(placement.turn[0]), y(placement.turn[1]);
    const glm::dvec2 centre(placement.point(box.centre())), stockCentre(stock.centre()), half(0.5 * box.size()),
        stockHalf(0.5 * stock.size());
    double depth = overlap(box.low.z + placement.shift.z, box.high.z + placement.shift.z, stock.low.z, stock.high.z);
    for (const glm::dvec2& axis : {glm::dvec2(1.0, 0.0), glm::dvec2(0.0, 1.0), x, y}) {
        const double reach = half.x * std::abs(glm::dot(axis, x)) + half.y * std::abs(glm::dot(axis, y)) +
                             stockHalf.x * std::abs(axis.x) + stockHalf.y * std::abs(axis.y);
        depth = std::min(depth, reach - std::abs(glm::dot(axis, centre - stockCentre)));
    }
    return depth;
}

double roundDepth(const Placement& placement, const glm::dvec2& middle, const RoundStep& step, const Box& stock) {
    const glm::dvec2 centre(placement.point(glm::dvec3(middle, 0.0)));
    const glm::dvec2 out = glm::abs(centre - glm::dvec2(stock.centre())) - 0.5 * glm::dvec2(stock.size());
    const double away =
        std::max(out.x, out.y) <= 0.0 ? std::max(out.x, out.y) : glm::length(glm::max(out, glm::dvec2(0.0)));
    return std::min(step.radius - away,
                    overlap(step.low + placement.shift.z, step.high + placement.shift.z, stock.low.z, stock.high.z));
}

double depthOfBox(const Placement& placement, const Box& box, const StockSolid& stock) {
    return stock.isBox() ? boxDepth(placement, box, stock.box()) : stock.depthInBox(box, placement);
}

double depthOfRound(const Placement& placement, const glm::dvec2& middle, const RoundStep& step,
                    const StockSolid& stock) {
    if (stock.isBox()) return roundDepth(placement, middle, step, stock.box());
    return stock.depthInCylinder(glm::dvec2(placement.point(glm::dvec3(middle, 0.0))), step.radius,
                                 step.low + placement.shift.z, step.high + placement.shift.z);
}

double gapOfVise(const FixtureDesign& design, const StockSolid& stock) {
    const auto extent = stock.extentIn(placementOf(design), gripOf(design), 0);
    return extent ? valueOf(design, "opening") - (extent->high - extent->low) : std::numeric_limits<double>::infinity();
}

/// From the clamp's plane to the stock. @param axis of the fixture's frame
double gapBefore(const FixtureDesign& design, const StockSolid& stock, int axis) {
    const auto extent = stock.extentIn(placementOf(design), gripOf(design), axis);
    return extent ? -extent->high : std::numeric_limits<double>::infinity();
}

double counted(double depth) noexcept {
    return depth > touching ? depth : 0.0;
}

/// 0 for a shape that is not judged.
double depthOfShape(const Obstacle& obstacle, const StockSolid& stock) {
    if (const auto* box = std::get_if<Box>(&obstacle.shape)) return depthOfBox({}, *box, stock);
    const auto* cylinder = std::get_if<CylinderShape>(&obstacle.shape);
    if (cylinder == nullptr || std::abs(cylinder->axis.z) < uprightCosine) return 0.0;
    const double end = cylinder->base.z + std::copysign(cylinder->height, cylinder->axis.z);
    const RoundStep step{cylinder->radius, std::min(cylinder->base.z, end), std::max(cylinder->base.z, end)};
    return depthOfRound({}, glm::dvec2(cylinder->base), step, stock);
}

} // namespace

double depthIn(const FixtureDesign& design, const StockSolid& stock) {
    const FixtureSolids solids = solidsOf(design);
    const Placement placement = placementOf(design);
    double deepest = 0.0;
    if (stock.empty()) return deepest;
    for (const Box& box : solids.boxes) deepest = std::max(deepest, depthOfBox(placement, box, stock));
    for (const RoundBody& body : solids.rounds)
        for (const RoundStep& step : body.steps)
            if (!step.inStock) deepest = std::max(deepest, depthOfRound(placement, body.centre, step, stock));
    return counted(deepest);
}

std::optional<double> gapTo(const FixtureDesign& design, const StockSolid& stock) {
    std::optional<double> gap;
    switch (design.kind) {
    case FixtureKind::vise:
        gap = gapOfVise(design, stock);
        break;
    case FixtureKind::stepClamp:
        gap = gapBefore(design, stock, 2);
        break;
    case FixtureKind::toeClamp:
        gap = gapBefore(design, stock, 0);
        break;
    case FixtureKind::hexScrew:
    case FixtureKind::socketScrew:
    case FixtureKind::parallels:
    case FixtureKind::plate:
        break;
    }
    return gap && *gap <= touching ? std::optional(0.0) : gap;
}

FixtureFit fitOf(const FixtureDesign& design, const StockSolid& stock) {
    return {depthIn(design, stock), gapTo(design, stock).value_or(0.0)};
}

FixtureFit fitOf(const Obstacle& obstacle, const StockSolid& stock) {
    if (obstacle.kind == ObstacleKind::keepOut || stock.empty()) return {};
    if (obstacle.design) return fitOf(*obstacle.design, stock);
    return {counted(depthOfShape(obstacle, stock)), 0.0};
}

Result<std::vector<BadFit>> badFits(const Model& model, const Setup& setup, std::span<const Obstacle> obstacles,
                                    Progress& progress) {
    std::vector<BadFit> bad;
    const auto judged = [](const Obstacle& one) {
        return one.on && one.kind == ObstacleKind::fixture &&
               (one.design || !std::holds_alternative<TriangleMesh>(one.shape));
    };
    if (std::ranges::none_of(obstacles, judged)) return bad;
    const Result<StockSolid> stock = StockSolid::of(model, setup, progress);
    if (!stock) return stock.error();
    for (const Obstacle& obstacle : obstacles) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "fixtures", {}, {}};
        if (!judged(obstacle)) continue;
        if (const FixtureFit fit = fitOf(obstacle, *stock); !fit.isGood()) bad.push_back({obstacle.name, fit});
    }
    return bad;
}

} // namespace burin
