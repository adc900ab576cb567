// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/traced_bounds.h"
#include "core/job/touched_stock.h"

#include <algorithm>
#include <array>

namespace burin {
namespace {

using Layer = TracedSession::Layer;

constexpr std::array<const char*, 5> kinds{"part", "fixture", "keep_out", "machine_travel",
                                           "stock"}; // in the order of BoundLayer::Kind

const char* kindOf(BoundLayer::Kind kind) noexcept {
    return kinds[static_cast<std::size_t>(kind)];
}

bool names(const std::vector<Layer>& layers, BoundLayer::Kind kind) {
    return std::ranges::any_of(layers, [kind](const Layer& layer) { return layer.kind == kindOf(kind); });
}

bool sameLayer(const Layer& one, const Layer& other) {
    return one.kind == other.kind && one.name == other.name;
}

/// Obstacles are the layers behind the part, in order.
void switchAs(const std::vector<Layer>& layers, std::vector<Obstacle>& obstacles) {
    for (std::size_t i = 0; i < obstacles.size() && i + 1 < layers.size(); ++i) obstacles[i].on = layers[i + 1].on;
}

bool switchesLayers(const SessionTrace& trace) {
    return std::ranges::any_of(
        trace.changes, [](const TimedChange& timed) { return std::holds_alternative<LayerSwitch>(timed.change); });
}

Result<ToolBounds> madeAsTraced(const MillingContext& milling, const AxisMode& axis, const Surroundings& surroundings,
                                double allowance, const SessionTrace& trace, Progress& progress) {
    if (trace.began && trace.began->growth && !axis.free)
        return ToolBounds::asGrown(milling, milling.tool, axis, surroundings, trace, progress);
    return ToolBounds::build(milling, milling.tool, axis, surroundings, allowance, progress);
}

} // namespace

std::vector<Layer> tracedLayers(const ToolBounds& bounds) {
    std::vector<Layer> layers;
    for (const BoundLayer& layer : bounds.layers()) layers.push_back({kindOf(layer.kind), layer.name, layer.on});
    return layers;
}

Result<ToolBounds> boundsAsTraced(const MillingContext& milling, const AxisMode& axis, TravelPlacement travel,
                                  double allowance, const SessionTrace& trace, Progress& progress) {
    const std::vector<Layer> layers = trace.began ? trace.began->layers : std::vector<Layer>{};
    Surroundings surroundings = surroundingsOf(milling, travel, axis);
    if (layers.empty()) return madeAsTraced(milling, axis, surroundings, allowance, trace, progress);
    travel.on = names(layers, BoundLayer::Kind::machineTravel);
    Surroundings then = surroundingsOf(milling, travel, axis);
    switchAs(layers, then.obstacles);
    Result<ToolBounds> bounds = madeAsTraced(milling, axis, then, allowance, trace, progress);
    if (!bounds) return bounds;
    if (names(layers, BoundLayer::Kind::stock)) {
        Result<TouchableStock> stock = TouchableStock::of(*milling.model, milling.setup, progress);
        if (!stock) return stock.error();
        bounds->addStock(std::make_shared<const TouchableStock>(std::move(*stock)));
    }
    if (std::ranges::equal(tracedLayers(*bounds), layers, sameLayer)) return bounds;
    if (switchesLayers(trace))
        return Error{ErrorCode::argumentInvalid,
                     "trace",
                     {},
                     "one that was recorded with the fixtures, keep-out volumes and machine of this project"};
    return madeAsTraced(milling, axis, surroundings, allowance, trace, progress);
}

} // namespace burin
