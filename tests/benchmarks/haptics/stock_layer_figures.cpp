// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/haptics/haptic_groups.h"
#include "tests/benchmarks/measure/replay.h"
#include "tests/core/haptics/haptic_rig.h"

#include <cmath>
#include <optional>

namespace burin::benchmarks {

namespace {

constexpr double kept = 1.0, bottomOfShank = 5.0; // mm: the distance; above the tip
constexpr std::size_t stockTicks = 6000;

/// A tool with a shank wider than its flutes, and a holder not far above.
Tool toolOverStock() {
    Tool tool = test::ballTool(bottomOfShank, 12.0);
    tool.cutter.stickOut = 18.0;
    tool.cutter.holder = {{40.0, 40.0, 15.0}, {40.0, 50.0, 20.0}};
    return tool;
}

HapticSettings settingsWith(std::optional<bool> layer) {
    HapticSettings settings = test::Rig::settings();
    if (layer) settings.stock = {kept, *layer};
    return settings;
}

/// The hand mills a wave through the block, a millimetre deeper than the shank may come to its top, so that the shank
/// slides over the stock half of the time.
glm::dvec3 wave(std::size_t tick) {
    const double angle = 2.0 * pi * static_cast<double>(tick) / static_cast<double>(stockTicks);
    return {13.0 * std::sin(3.0 * angle), 13.0 * std::cos(2.0 * angle), kept - bottomOfShank + std::cos(16.0 * angle)};
}

/// Least times of each tick over replays on the uncut block, µs.
std::vector<double> ticksOver(std::optional<bool> layer) {
    std::optional<test::Rig> rig;
    const auto restart = [&] {
        rig.emplace(settingsWith(layer), toolOverStock());
        rig->begin({0.0, 13.0, 5.0});
        rig->moveTo(wave(0), 50.0);
    };
    return leastOfReplays(stockTicks, restart, [&](std::size_t tick) { rig->feed(wave(tick)); });
}

/// Flat face of the shank over the flat top of the stock: how far from its distance the shank comes to rest, mm.
double distanceError() {
    HapticSettings settings = settingsWith(true);
    settings.felt.gain = settings.felt.friction = 0.0;
    test::Rig rig(settings, toolOverStock());
    rig.begin({0.0, 0.0, 5.0});
    rig.moveTo({0.0, 0.0, -bottomOfShank - 2.0}, 50.0);
    return std::abs(rig.rest(200).proxy.tip.z + bottomOfShank - kept);
}

void addTicks(Session& session, const std::string& stem, std::optional<bool> layer) {
    session.stage(stem);
    const std::vector<double> times = session.least(stem, ticksOver(layer));
    session.add(figure(stem + ".p50", percentile(times, 0.5), "us", 50.0));
    session.add(figure(stem + ".p999", percentile(times, 0.999), "us", 300.0));
    session.add(figure(stem + ".max", percentile(times, 1.0), "us", 700.0));
}

} // namespace

void stockLayerFigures(Session& session) {
    if (!session.wants("stock_layer.")) return;
    addTicks(session, "stock_layer.none.tick_us", std::nullopt);
    addTicks(session, "stock_layer.off.tick_us", false);
    addTicks(session, "stock_layer.on.tick_us", true);
    session.stage("stock_layer.distance_error_mm");
    session.add(figure("stock_layer.distance_error_mm", distanceError(), "mm", 0.002));
}

} // namespace burin::benchmarks
