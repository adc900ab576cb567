// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/ray_cast.h"
#include "core/volume/surface/surface.h"
#include "tests/benchmarks/milled_sample.h"

#include <benchmark/benchmark.h>

using namespace burin;
using burin::test::MilledSample;

namespace {

constexpr double voxel = 0.25; // the sample: 480 × 280 × 180 voxels

MilledSample& sample() {
    static MilledSample made(voxel);
    return made;
}

SurfaceDetail detailOf(const benchmark::State& state, std::size_t first) {
    return {static_cast<int>(state.range(first)), static_cast<double>(state.range(first + 1)) / 100.0 * voxel};
}

/// Arguments: tile u, v, level, tolerance in hundredths of a voxel. (7, 2): finished dome and scallops; (14, 8): a
/// corner of the stock.
void surfaceTile(benchmark::State& state) {
    const VolumeSnapshot workpiece = sample().workpiece.snapshot();
    SurfaceExtractor extractor;
    SurfaceMesh mesh;
    const SurfaceTile tile{static_cast<std::int32_t>(state.range(0)), static_cast<std::int32_t>(state.range(1))};
    for (auto _ : state) extractor.extract(workpiece, tile, detailOf(state, 2), mesh);
    state.counters["triangles"] = static_cast<double>(mesh.triangles.size() / 3);
}

/// Arguments: level, tolerance in hundredths of a voxel.
void wholeSurface(benchmark::State& state) {
    const VolumeSnapshot workpiece = sample().workpiece.snapshot();
    SurfaceExtractor extractor;
    SurfaceMesh mesh;
    const glm::ivec2 tiles = surfaceTiles(workpiece.grid());
    std::size_t triangles = 0;
    for (auto _ : state) {
        triangles = 0;
        for (int v = 0; v < tiles.y; ++v)
            for (int u = 0; u < tiles.x; ++u) {
                extractor.extract(workpiece, {u, v}, detailOf(state, 0), mesh);
                triangles += mesh.triangles.size() / 3;
            }
    }
    state.counters["triangles"] = static_cast<double>(triangles);
}

/// The cost of a move of 0.3 mm: finding the changed tiles and making their surface. Arguments: level, hundredths of a
/// voxel.
void changedTiles(benchmark::State& state) {
    MilledSample milled(voxel);
    SurfaceExtractor extractor;
    SurfaceMesh mesh;
    VolumeSnapshot before = milled.workpiece.snapshot();
    double x = 20.0, y = 36.0;
    std::size_t tiles = 0;
    for (auto _ : state) {
        state.PauseTiming();
        milled.pass(y, x, x + 0.3, 0.02);
        x += 0.3;
        if (x > 100.0) {
            x = 20.0;
            y += 1.0;
        }
        const VolumeSnapshot now = milled.workpiece.snapshot();
        state.ResumeTiming();
        for (const SurfaceTile tile : changedSurface(before, now, static_cast<int>(state.range(0)))) {
            extractor.extract(now, tile, detailOf(state, 0), mesh);
            ++tiles;
        }
        before = now;
    }
    state.counters["tiles"] = benchmark::Counter(static_cast<double>(tiles), benchmark::Counter::kAvgIterations);
}

void rayFromTheCamera(benchmark::State& state) {
    const VolumeSnapshot workpiece = sample().workpiece.snapshot();
    double turn = 0.0;
    for (auto _ : state) {
        turn += 0.1;
        const glm::dvec3 eye(60.0 + 200.0 * std::cos(turn), 35.0 + 200.0 * std::sin(turn), 150.0);
        benchmark::DoNotOptimize(castRay(workpiece, eye, glm::dvec3(60.0, 35.0, 20.0) - eye));
    }
}

} // namespace

BENCHMARK(surfaceTile)
    ->ArgNames({"u", "v", "level", "tolerance"})
    ->ArgsProduct({{7}, {2}, {0, 1}, {0, 5, 10}})
    ->ArgsProduct({{14}, {8}, {0, 1}, {0, 5, 10}})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(wholeSurface)
    ->ArgNames({"level", "tolerance"})
    ->ArgsProduct({{0, 1}, {0, 5, 10}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(changedTiles)
    ->ArgNames({"level", "tolerance"})
    ->ArgsProduct({{0, 1}, {0, 10}})
    ->Iterations(200)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(rayFromTheCamera);
