// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/boolean.h"
#include "core/volume/operations/boundary.h"
#include "tests/benchmarks/figure_groups.h"
#include "tests/benchmarks/measure/replay.h"
#include "tests/benchmarks/peers/openvdb.h"
#include "tests/benchmarks/scenes/cutting_scene.h"

#include <array>

namespace burin::benchmarks {

namespace {

constexpr int repetitions = 7; // for works of some ms; the least time is used

/// Removes a thin slice from the top of one line in each of several tiles.
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
        touchTiles(volume, top -= 64); // in the cache, as below a tool
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
    session.add(figure("snapshot.us", session.least("snapshot.us", percentile(taking, 0.5)), "us", 1.0));
    session.add(
        figure("snapshot.first_touch_us", (percentile(first, 0.5) - percentile(again, 0.5)) / tiles, "us", 0.5));
}

void boundaryFigures(Session& session) {
    if (!session.wants("boundary.1024")) return;
    session.stage("boundary.1024");
    RunVolume volume = layeredBlock(1024);
    const VolumeSnapshot snapshot = volume.snapshot();
    std::uint64_t voxels = 0;
    const double spent = leastSeconds(repetitions, [&] { voxels = BoundaryList(snapshot).voxelCount(); });
    session.add(figure("boundary.1024", session.least("boundary.1024", 1e3 * spent), "ms", 40.0));
    std::size_t listed = 0;
    const double listing = leastSeconds(repetitions, [&] { listed = boundaryVoxels(snapshot).size(); });
    session.check(listed == voxels, "boundary voxels one by one are those of the list");
    session.add(figure("boundary.1024.one_by_one", session.least("boundary.1024.one_by_one", 1e3 * listing), "ms"));
    session.add(figure("boundary.1024.voxels", static_cast<double>(voxels), "voxels"));
}

namespace {

std::uint64_t solidUnits(const RunAmounts& amounts) {
    std::uint64_t units = 0;
    for (std::size_t i = 1; i < amounts.units.size(); ++i) units += amounts.units[i];
    return units;
}

/// One of the three operations, with a result in a volume whose memory is already allocated, and in a new one.
struct Operation {
    const char* name;
    Result<void> (*into)(RunVolume&, const VolumeSnapshot&, const VolumeSnapshot&);
    Result<RunVolume> (*of)(const VolumeSnapshot&, const VolumeSnapshot&);
};
constexpr std::array operations{Operation{"boolean.union.1024", uniteInto, unionOf},
                                Operation{"boolean.intersection.1024", intersectInto, intersectionOf},
                                Operation{"boolean.difference.1024", subtractInto, differenceOf}};

} // namespace

void booleanFigures(Session& session) {
    if (!session.wants("boolean.")) return;
    session.stage("boolean");
    RunVolume first = layeredBlock(1024), second = shiftedBlock(1024);
    const VolumeSnapshot a = first.snapshot(), b = second.snapshot();
    std::array<double, 3> into{}, of{};
    std::array<std::uint64_t, 3> solid{};
    RunVolume result = require(RunVolume::make(a.grid(), a.properties()), "a benchmark's volume");
    const VolumeSnapshot empty = result.snapshot();
    for (std::size_t i = 0; i < operations.size(); ++i) {
        const Operation& operation = operations[i];
        into[i] = 1e3 * leastSeconds(
                            repetitions, [&] { result.restore(empty); },
                            [&] {
                                if (const Result<void> done = operation.into(result, a, b); !done)
                                    throw std::runtime_error(operation.name);
                            });
        solid[i] = solidUnits(result.snapshot().amounts());
        of[i] = 1e3 * leastSeconds(repetitions, [&] { (void)require(operation.of(a, b), operation.name); });
    }
    const std::uint64_t alone = solidUnits(a.amounts()), both = alone + solidUnits(b.amounts());
    session.check(solid[0] + solid[1] == both && solid[2] + solid[1] == alone,
                  "|A| + |B| = |A or B| + |A and B|, |A| = |A without B| + |A and B|");
    session.stage("boolean, OpenVDB");
    const auto theirs = levelSetBooleanTimes(layeredBlockBox(1024.0), shiftedBlockBox(1024.0), repetitions);
    for (std::size_t i = 0; i < operations.size(); ++i) {
        const std::string name = operations[i].name;
        const auto add = [&](Figure entry, std::optional<double> ratio) {
            entry.value = session.least(entry.name, entry.value);
            session.add(theirs ? against(std::move(entry), "OpenVDB level set, csg...Copy",
                                         session.least(name + ", OpenVDB", (*theirs)[i]), ratio)
                               : std::move(entry));
        };
        add(figure(name, into[i], "ms", 15.0), 3.0);
        add(figure(name + ".new_volume", of[i], "ms"), std::nullopt);
    }
}

} // namespace burin::benchmarks
