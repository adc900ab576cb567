// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/haptics/first_cut.h"

#include "core/haptics/haptic_step.h"
#include "core/haptics/operator/virtual_operator.h"

#include <chrono>
#include <thread>

namespace burin::benchmarks {

namespace {

constexpr double handSpeed = 100.0;      // mm/s
constexpr double maximumAllowance = 2.0; // mm, as in the window
constexpr int mostTicks = 30'000;

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

} // namespace

Result<FirstCut> firstCut(MillingContext& milling, Progress& progress) {
    FirstCut first;
    const Clock::time_point begin = Clock::now();
    const AxisMode axis;
    const Result<ToolBounds> bounds =
        ToolBounds::grow(milling, lent(milling.part), milling.tool, axis, surroundingsOf(milling, milling.travel, axis),
                         maximumAllowance, {}, progress);
    if (!bounds) return bounds.error();
    first.ready = secondsSince(begin);

    HapticSettings settings;
    settings.stylus = touchLikeStylus();
    settings.cuttingSpeed = milling.conditions.surfaceSpeed;
    HapticStep step(milling.embedded.workpiece, bounds->boundaryLayers(), milling.tool, settings);
    const glm::dvec3 centre = milling.setup.stock.centre();
    const double from = milling.safeHeight(), to = milling.setup.stock.high.z - milling.setup.voxel;
    first.hand = (from - to) / handSpeed;
    Clock::time_point edge = Clock::now();
    for (int tick = 0; tick < mostTicks && !progress.cancelled(); ++tick) {
        step.takeTiles();
        StylusState state;
        state.time = settings.tickPeriod * tick;
        state.pose.position = {centre.x, centre.y, std::max(to, from - handSpeed * state.time)};
        state.valid = true;
        const Sample sample = step.advance(state, settings.tickPeriod);
        if ((sample.flags & sampleOnBoundary) != 0) ++first.ticksHeld;
        if (sample.removed[0].units > 0) {
            first.cut = secondsSince(begin);
            step.settle();
            first.fieldBytes = bounds->memoryBytes();
            return first;
        }
        edge += std::chrono::microseconds(1000);
        std::this_thread::sleep_until(edge);
    }
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "first cut", {}, {}};
    return Error{ErrorCode::notSupported, "first cut", "stock above the part in the middle", {}};
}

} // namespace burin::benchmarks
