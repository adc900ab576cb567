// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/figure_groups.h"
#include "tests/benchmarks/measure/milling.h"
#include "tests/benchmarks/peers/cutting_peer.h"
#include "tests/benchmarks/scenes/cutting_scene.h"
#include "tests/benchmarks/scenes/tool_paths.h"

#include <array>

namespace burin::benchmarks {

namespace {

// The slot of core/cutting/README.md. Lengths in mm unless a name says voxels.
constexpr double edge = 0.2, radius = 3.0, depth = 1.5, feed = 10.0, tickPeriod = 1e-3;
constexpr double radiusVoxels = radius / edge, depthVoxels = depth / edge, stepVoxels = feed * tickPeriod / edge;
constexpr glm::ivec3 extent(112, 112, 44); // voxels
constexpr double topVoxels = 28.0;
constexpr std::size_t settlingTicks = 200, countedTicks = 600;
constexpr int phases = 6;
constexpr std::array directions{glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(0.6, 0.8, 0.0),
                                glm::dvec3(0.48, 0.6, -0.02)};

/// One slot: its direction and the stock beside it.
struct Slot {
    glm::dvec3 direction; ///< unit
    bool half = false;
    int phase = 0;

    glm::dvec3 tip(std::size_t tick) const { // voxels
        // Phases shift the path relative to the lines, along it and across it.
        const glm::dvec3 middle(0.5 * extent.x, 0.5 * extent.y, topVoxels - depthVoxels);
        const glm::dvec3 shift = static_cast<double>(phase) / phases * glm::dvec3(1.0, 0.6180339887498949, 0.0);
        const double way = stepVoxels * (static_cast<double>(tick) - 0.5 * (settlingTicks + countedTicks));
        return middle + shift + way * direction;
    }
    SlotStock stock(double voxelEdge, RunAxis axis) const {
        return {extent, voxelEdge, axis, topVoxels, half, {-direction.y, direction.x}, glm::dvec2(tip(0))};
    }
};

/// Standard deviation over mean of ticks, with the linear trend removed.
double variation(const std::vector<double>& ticks) {
    const auto count = static_cast<double>(ticks.size());
    double mean = 0.0, slope = 0.0, weight = 0.0, square = 0.0;
    for (const double tick : ticks) mean += tick / count;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const double place = static_cast<double>(i) - 0.5 * (count - 1.0);
        slope += place * ticks[i];
        weight += place * place;
    }
    slope /= weight;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const double place = static_cast<double>(i) - 0.5 * (count - 1.0);
        const double off = ticks[i] - mean - slope * place;
        square += off * off / count;
    }
    return std::sqrt(square) / mean;
}

/// The worst values of all slots so far.
struct Ripple {
    double reported = 0.0;      ///< cv
    double exact = 0.0;         ///< cv of what the runs lost
    double voxels = 0.0;        ///< cv of whole voxels
    double sumDifference = 0.0; ///< relative difference of the reported sum from the exact one
};

void millSlot(Session& session, CutterType type, const Slot& slot, RunAxis axis, Ripple& worst) {
    RunVolume workpiece = slotStock(slot.stock(edge, axis));
    Milling milling(workpiece, cutterOf(type, radius));
    const auto pose = [&](std::size_t tick) { return ToolPose{edge * slot.tip(tick), {0.0, 0.0, 1.0}}; };
    milling.restart(session, pose(0));
    milling.removal().reset(); // so that the plunge is not reported later
    std::vector<double> reported, exact;
    double reportedSum = 0.0, exactSum = 0.0;
    for (std::size_t i = 0; i < settlingTicks + countedTicks; ++i) {
        const CutResult cut = milling.tick(pose(i), pose(i + 1));
        milling.giveBackView();
        reportedSum += cut.reported;
        exactSum += cut.volume;
        if (i < settlingTicks) continue;
        reported.push_back(cut.reported);
        exact.push_back(cut.volume);
    }
    milling.finish(session);
    session.check(reportedSum > 0.0, "a slot reports a removed volume");
    worst.reported = std::max(worst.reported, variation(reported));
    worst.exact = std::max(worst.exact, variation(exact));
    worst.sumDifference = std::max(worst.sumDifference, std::abs(reportedSum / exactSum - 1.0));
}

/// The same slot in whole voxels; the direction of the runs makes no difference to them.
void millVoxels(CutterType type, const Slot& slot, Ripple& worst) {
    RunVolume workpiece = slotStock(slot.stock(1.0, RunAxis::z));
    const LineBlock all{{0, 0}, {extent.x - 1, extent.y - 1}};
    const auto peer = denseByteCutter(workpiece.snapshot(), all, endMillOf(cutterOf(type, radiusVoxels)));
    VoxelCounts removed{};
    peer->restart();
    peer->cut(slot.tip(0), slot.tip(0), removed);
    std::vector<double> counts;
    for (std::size_t i = 0; i < settlingTicks + countedTicks; ++i) {
        removed[1] = 0;
        peer->cut(slot.tip(i), slot.tip(i + 1), removed);
        if (i >= settlingTicks) counts.push_back(static_cast<double>(removed[1]));
    }
    worst.voxels = std::max(worst.voxels, variation(counts));
}

void ripple(Session& session, const std::string& name, CutterType type, double limit) {
    if (!session.wants(name)) return;
    session.stage(name);
    Ripple worst;
    for (const glm::dvec3& direction : directions)
        for (const bool half : {false, true})
            for (int phase = 0; phase < phases; ++phase) {
                Session::throwIfCancelled();
                const Slot slot{glm::normalize(direction), half, phase};
                for (const RunAxis axis : {RunAxis::z, RunAxis::x}) millSlot(session, type, slot, axis, worst);
                millVoxels(type, slot, worst);
            }
    session.add(against(figure(name, worst.reported, "cv", limit), "whole voxels", worst.voxels));
    session.add(figure(name + ".exact", worst.exact, "cv"));
    session.add(figure(name + ".sum_difference", worst.sumDifference, "1", 0.01));
}

/// A flat end mill faces a floor that lies within a voxel; measures the error of the run ends.
void floorHeight(Session& session) {
    const std::string name = "floor.height_error_voxel";
    if (!session.wants(name)) return;
    session.stage(name);
    RunVolume workpiece = slotStock(Slot{glm::dvec3(1.0, 0.0, 0.0)}.stock(edge, RunAxis::z));
    Milling milling(workpiece, cutterOf(CutterType::flat, radius));
    const double floor = topVoxels - 3.623; // voxels
    const auto pose = [&](double x, double y) { return ToolPose{edge * glm::dvec3(x, y, floor), {0.0, 0.0, 1.0}}; };
    milling.restart(session, pose(-radiusVoxels - 1.0, 0.0));
    for (double y = 0.0; y < extent.y + radiusVoxels; y += 0.8 * radiusVoxels)
        for (double x = -radiusVoxels - 1.0; x < extent.x + radiusVoxels; x += 1.0)
            milling.tick(pose(x, y), pose(x + 1.0, y));
    milling.finish(session);
    const Grid& grid = workpiece.grid();
    double worst = 0.0;
    for (std::int32_t v = 0; v < grid.lineCountV(); ++v)
        for (std::int32_t u = 0; u < grid.lineCountU(); ++u) {
            const double height = static_cast<double>(workpiece.line({u, v}).front().end()) / unitsPerVoxel;
            worst = std::max(worst, std::abs(height - floor));
        }
    session.add(figure(name, worst, "voxel", 0.02));
}

} // namespace

void smoothnessFigures(Session& session) {
    ripple(session, "ripple.ball", CutterType::ball, 0.05);
    ripple(session, "ripple.flat", CutterType::flat, 0.16);
    ripple(session, "ripple.bull", CutterType::bullNose, 0.16);
    floorHeight(session);
}

} // namespace burin::benchmarks
