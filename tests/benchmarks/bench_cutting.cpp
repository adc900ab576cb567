// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/removal.h"

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>

using namespace burin;

namespace {

constexpr int gridSide = 256; // voxels; cost does not depend on it

RunVolume solidBlock() {
    const Grid grid = Grid::make(glm::dvec3(0.0), 1.0, glm::ivec3(gridSide)).value();
    PropertyList properties;
    Property stock;
    stock.id = "stock";
    (void)properties.add(stock);
    RunVolume volume = RunVolume::make(grid, properties).value();
    (void)volume.fillBlock({0, 0}, {gridSide, gridSide}, 0, grid.lineEnd(), 1);
    return volume;
}

Cutter cutterOf(int kind, double radius) {
    const std::array corners{radius, 0.0, 0.25 * radius};
    const std::array types{CutterType::ball, CutterType::flat, CutterType::bullNose};
    const auto place = static_cast<std::size_t>(kind);
    const double shank = 1.9 * radius;
    return {types[place], 2.0 * radius, corners[place], 4.0 * radius, shank, 8.0 * radius, {{60.0, 60.0, 40.0}}};
}

/// Arguments: kind of end, radius in voxels, hundredths of a voxel a tick. The tool goes round in a circle that sinks
/// by a radius over one turn, so that it always cuts.
void cutTick(benchmark::State& state) {
    const double radius = static_cast<double>(state.range(1)), step = static_cast<double>(state.range(2)) / 100.0;
    const Cutter cutter = cutterOf(static_cast<int>(state.range(0)), radius);
    const double way = 0.2 * gridSide, middle = 0.5 * gridSide;
    RunVolume workpiece = solidBlock();
    MaterialRemoval removal(cutter, workpiece.grid());
    const auto tipAt = [&](double travelled) {
        const double angle = travelled / way;
        return glm::dvec3(middle + way * std::cos(angle), middle + way * std::sin(angle),
                          gridSide - 0.5 * radius - radius * angle / 6.2832);
    };
    double travelled = 0.0, removed = 0.0;
    for (auto _ : state) {
        if (tipAt(travelled).z < radius) { // through the block: begin with a new one
            state.PauseTiming();
            workpiece = solidBlock();
            travelled = 0.0;
            state.ResumeTiming();
        }
        const CutResult cut = removal.cut(workpiece, tipAt(travelled), tipAt(travelled + step));
        removed += cut.volume;
        travelled += step;
    }
    state.counters["voxels_per_tick"] = removed / static_cast<double>(state.iterations());
}

/// Shank and holder above a flat block: free space, and the shank in a shaft that it does not touch.
void shankTick(benchmark::State& state) {
    const double radius = static_cast<double>(state.range(0));
    const bool inShaft = state.range(1) != 0;
    const std::vector<RevolvedPiece> tool = pieces(cutterOf(0, radius));
    RunVolume workpiece = solidBlock();
    MaterialRemoval removal(cutterOf(1, radius + 2.0), workpiece.grid());
    const double middle = 0.5 * gridSide, deep = gridSide - 5.0 * radius, high = gridSide - radius;
    if (inShaft) removal.cut(workpiece, {middle, middle, gridSide}, {middle, middle, std::max(0.0, deep)});
    const glm::dvec3 tip(middle, middle, inShaft ? deep : high);
    for (auto _ : state) benchmark::DoNotOptimize(shankContact(workpiece, tool, tip).touches);
}

} // namespace

BENCHMARK(cutTick)->ArgNames({"end", "radius", "step"})->ArgsProduct({{0, 1, 2}, {6, 15, 50}, {5, 100}});
BENCHMARK(shankTick)->ArgNames({"radius", "shaft"})->ArgsProduct({{6, 50}, {0, 1}});

