// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/boolean.h"
#include "core/volume/boundary.h"
#include "tests/benchmarks/figure_groups.h"
#include "tests/benchmarks/measure/replay.h"
#include "tests/benchmarks/peers/openvdb.h"
#include "tests/benchmarks/scenes/cutting_scene.h"

#include <array>

namespace burin::benchmarks {

namespace {

constexpr int repetitions = 7; // of works of some ms; the least counts

/// Takes a thin slice off the top of one line in each of some tiles.
void touchTiles(RunVolume& volume, RunPosition top) {
    RunAmounts removed;
    constexpr std::int32_t tiles = 10, lines = 8;
    const std::int32_t middle = volume.grid().lineCountU() / 2;
    for (std::int32_t v = 0; v < tiles; ++v)
        for (std::int32_t u = 0; u < tiles; ++u)
            (void)volume.removeSpan({middle + u * lines, middle + v * lines}, top, top + 64, removed);
}

} // namespace

void snapshotFigures(Session& session) {
    if (!session.wants("snapshot.")) return;
    session.stage("snapshot");
    RunVolume volume = layeredBlock(2048);
    RunPosition top = volume.grid().lineEnd() / 2;
    VolumeSnapshot held;
    std::vector<double> taking, first, again;
    for (int i = 0; i < 500; ++i) {
        touchTiles(volume, top -= 64); // in the cache, as under a tool
        const Clock::time_point start = Clock::now();
        VolumeSnapshot next = volume.snapshot();
        const Clock::time_point taken = Clock::now();
        touchTiles(volume, top -= 64);
        const Clock::time_point touched = Clock::now();
        touchTiles(volume, top -= 64);
        const Clock::time_point touchedAgain = Clock::now();
        taking.push_back(microseconds(taken - start));
        first.push_back(microseconds(touched - taken));
        again.push_back(microseconds(touchedAgain - touched));
        held = std::move(next);
    }
    constexpr double tiles = 100.0;
    session.add(figure("snapshot.us", percentile(taking, 0.5), "us", 1.0));
    session.add(
        figure("snapshot.first_touch_us", (percentile(first, 0.5) - percentile(again, 0.5)) / tiles, "us", 0.5));
}

void boundaryFigures(Session& session) {
    if (!session.wants("boundary.1024")) return;
    session.stage("boundary.1024");
    RunVolume volume = layeredBlock(1024);
    const VolumeSnapshot snapshot = volume.snapshot();
    std::size_t voxels = 0;
    const double spent = leastSeconds(repetitions, [&] { voxels = boundaryVoxels(snapshot).size(); });
    session.add(figure("boundary.1024", 1e3 * spent, "ms", 40.0));
    session.add(figure("boundary.1024.voxels", static_cast<double>(voxels), "voxels"));
}

void booleanFigures(Session& session) {
    if (!session.wants("boolean.")) return;
    session.stage("boolean");
    RunVolume first = layeredBlock(1024), second = shiftedBlock(1024);
    const VolumeSnapshot a = first.snapshot(), b = second.snapshot();
    using Operation = Result<RunVolume> (*)(const VolumeSnapshot&, const VolumeSnapshot&);
    constexpr std::array<Operation, 3> operations{unionOf, intersectionOf, differenceOf};
    constexpr std::array names{"boolean.union.1024", "boolean.intersection.1024", "boolean.difference.1024"};
    std::array<double, 3> ours{};
    std::array<std::uint64_t, 3> solid{};
    for (std::size_t i = 0; i < operations.size(); ++i)
        ours[i] = 1e3 * leastSeconds(repetitions, [&] {
                      const RunVolume result = require(operations[i](a, b), names[i]);
                      solid[i] = 0;
                      for (std::size_t p = 1; p < 256; ++p) solid[i] += result.amounts().units[p];
                  });
    std::uint64_t both = 0;
    for (std::size_t p = 1; p < 256; ++p) both += a.amounts().units[p] + b.amounts().units[p];
    std::uint64_t alone = 0;
    for (std::size_t p = 1; p < 256; ++p) alone += a.amounts().units[p];
    session.check(solid[0] + solid[1] == both && solid[2] + solid[1] == alone,
                  "|A| + |B| = |A or B| + |A and B|, |A| = |A without B| + |A and B|");
    session.stage("boolean, OpenVDB");
    const auto theirs = levelSetBooleanTimes(layeredBlockBox(1024.0), shiftedBlockBox(1024.0), 5);
    for (std::size_t i = 0; i < names.size(); ++i) {
        Figure entry = figure(names[i], ours[i], "ms", 15.0);
        session.add(theirs ? against(std::move(entry), "OpenVDB level set, csg...Copy", (*theirs)[i], 3.0)
                           : std::move(entry));
    }
}

} // namespace burin::benchmarks
