// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/volume_memory.h"
#include "tests/benchmarks/figure_groups.h"
#include "tests/benchmarks/measure/milling.h"
#include "tests/benchmarks/peers/octree_size.h"
#include "tests/benchmarks/peers/openvdb.h"
#include "tests/benchmarks/scenes/cutting_scene.h"
#include "tests/benchmarks/scenes/tool_paths.h"

#include <vector>

namespace burin::benchmarks {

namespace {

/// What other forms need for the same volume.
struct PeerSize {
    std::string name, suffix;
    double bytes = 0.0;
};

std::vector<PeerSize> peerSizes(Run& run, const VolumeSnapshot& volume) {
    const glm::dvec3 count(volume.grid().count());
    const double voxels = count.x * count.y * count.z;
    std::vector<PeerSize> sizes{{"dense bytes", "", voxels},
                                {"dense bits, no material", ".against_bits", voxels / 8.0}};
    run.stage("memory, OpenVDB");
    if (const std::optional<std::uint64_t> bytes = openVdbBytes(volume))
        sizes.push_back({"OpenVDB Int8 tree", ".against_openvdb", static_cast<double>(*bytes)});
    run.stage("memory, octree");
    sizes.push_back({"octree, 8-byte nodes", ".against_octree", static_cast<double>(octreeBytes(volume))});
    return sizes;
}

/// How many times smaller each peer, in the order of peerSizes, has to be beaten by; 0: not asked for.
struct RatiosAtLeast {
    double bytes = 0.0, bits = 0.0, openVdb = 0.0, octree = 0.0;
    std::optional<double> of(const std::string& suffix) const {
        const double ratio = suffix.empty()                 ? bytes
                             : suffix == ".against_bits"    ? bits
                             : suffix == ".against_openvdb" ? openVdb
                                                            : octree;
        return ratio > 0.0 ? std::optional(ratio) : std::nullopt;
    }
};

void add(Run& run, const std::string& name, double bytes, double per, std::optional<double> limit,
         const std::vector<PeerSize>& peers, const RatiosAtLeast& ratios) {
    for (const PeerSize& peer : peers) {
        const bool main = peer.suffix.empty();
        run.add(against(figure(name + peer.suffix, bytes / per, "B", main ? limit : std::nullopt), peer.name,
                        peer.bytes / per, ratios.of(peer.suffix)));
    }
}

void newBlock(Run& run) {
    run.stage("memory, a new block of 2048 x 2048 x 2048");
    RunVolume volume = layeredBlock(2048);
    const VolumeSnapshot snapshot = volume.snapshot();
    const VolumeMemory memory = memoryOf(snapshot);
    const auto bytes = static_cast<double>(memory.bytes());
    const auto lines = static_cast<double>(memory.lines), runs = static_cast<double>(memory.runs);
    run.add(figure("memory.runs_per_line", runs / lines, "1"));
    const std::vector<PeerSize> peers = peerSizes(run, snapshot);
    add(run, "memory.hot.bytes_per_line", bytes, lines, 25.0, peers, {.octree = 1.0});
    add(run, "memory.hot.bytes_per_run", bytes, runs, 8.5, peers, {.octree = 1.0});
}

} // namespace

void memoryFigures(Run& run) {
    if (run.wants("memory.hot") || run.wants("memory.packed.bytes_per_run.new") || run.wants("memory.runs_per_line"))
        newBlock(run);
}

} // namespace burin::benchmarks
