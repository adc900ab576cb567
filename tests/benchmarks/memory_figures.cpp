// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/packed/packed_volume.h"
#include "core/volume/runs/volume_memory.h"
#include "tests/benchmarks/figure_groups.h"
#include "tests/benchmarks/measure/milling.h"
#include "tests/benchmarks/peers/octree_size.h"
#include "tests/benchmarks/peers/openvdb.h"
#include "tests/benchmarks/scenes/cutting_scene.h"
#include "tests/benchmarks/scenes/tool_paths.h"

#include <algorithm>
#include <vector>

namespace burin::benchmarks {

namespace {

/// The memory that other representations need for the same volume.
struct PeerSize {
    std::string name, suffix;
    double bytes = 0.0;
};

std::vector<PeerSize> peerSizes(Session& session, const VolumeSnapshot& volume) {
    const glm::dvec3 count(volume.grid().count());
    const double voxels = count.x * count.y * count.z;
    std::vector<PeerSize> sizes{{"dense bytes", "", voxels},
                                {"dense bits, no material", ".against_bits", voxels / 8.0}};
    session.stage("memory, OpenVDB");
    if (const std::optional<std::uint64_t> bytes = openVdbBytes(volume))
        sizes.push_back({"OpenVDB Int8 tree", ".against_openvdb", static_cast<double>(*bytes)});
    session.stage("memory, octree");
    sizes.push_back({"octree, 8-byte nodes", ".against_octree", static_cast<double>(octreeBytes(volume))});
    return sizes;
}

/// By which factor each peer, in the order of peerSizes, has to be larger; 0: not required.
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

void add(Session& session, const std::string& name, double bytes, double per, std::optional<double> limit,
         const std::vector<PeerSize>& peers, const RatiosAtLeast& ratios) {
    for (const PeerSize& peer : peers) {
        const bool main = peer.suffix.empty();
        session.add(against(figure(name + peer.suffix, bytes / per, "B", main ? limit : std::nullopt), peer.name,
                            peer.bytes / per, ratios.of(peer.suffix)));
    }
}

/// Packs a state, verifies that nothing of it is lost, and adds its bytes per run.
void packedFigures(Session& session, const std::string& name, const VolumeSnapshot& snapshot, double limit,
                   const std::vector<PeerSize>& peers, const RatiosAtLeast& ratios) {
    session.stage(name);
    Progress progress;
    const PackedVolume packed = require(PackedVolume::pack(snapshot, progress), "packing");
    const VolumeMemory memory = memoryOf(snapshot);
    const auto bytes = static_cast<double>(packed.memoryBytes()), runs = static_cast<double>(memory.runs);
    add(session, name, bytes, runs, limit, peers, ratios);
    session.add(figure(name + ".runs_per_line", runs / static_cast<double>(memory.lines), "1"));
    session.add(figure(name + ".hot_bytes_per_run", memory.bytesPerRun(), "B"));
    const Grid& grid = snapshot.grid();
    std::size_t different = 0;
    BrickLines brick(grid.lineEnd());
    for (std::int32_t v = 0; v < grid.lineCountV(); v += brickSide)
        for (std::int32_t u = 0; u < grid.lineCountU(); u += brickSide) {
            packed.brick({u, v}, brick);
            for (std::int32_t i = 0; i < linesPerBrick; ++i) {
                const auto line = snapshot.line({u + i % brickSide, v + i / brickSide});
                different += std::ranges::equal(line, brick.line(i)) ? 0U : 1U;
            }
        }
    session.check(different == 0, name + ": packing loses nothing (" + std::to_string(different) + " lines differ)");
}

/// Six long overlapping walks with a short tool, whose tunnels cross each other.
void millHeavily(Session& session, RunVolume& volume, std::size_t ticksAWalk) {
    const double side = volume.grid().lineCountU();
    Cutter cutter = cutterOf(CutterType::ball, 50.0);
    cutter.fluteLength = cutter.radius();
    Milling milling(volume, cutter);
    bool first = true;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        const std::vector<ToolPose> path = upright(walk(side, 50.0, 1.0, ticksAWalk, seed));
        if (first) milling.restart(session, path.front());
        first = false;
        for (std::size_t i = 0; i + 1 < path.size(); ++i) {
            milling.tick(path[i], path[i + 1]);
            milling.giveBackView();
            Session::throwIfCancelled();
        }
    }
    milling.finish(session);
}

void newBlock(Session& session) {
    session.stage("memory, a new block of 2048 x 2048 x 2048");
    RunVolume volume = layeredBlock(2048);
    const VolumeSnapshot snapshot = volume.snapshot();
    const VolumeMemory memory = memoryOf(snapshot);
    const auto bytes = static_cast<double>(memory.bytes());
    const auto lines = static_cast<double>(memory.lines), runs = static_cast<double>(memory.runs);
    const std::vector<PeerSize> peers = peerSizes(session, snapshot);
    add(session, "memory.hot.bytes_per_line", bytes, lines, 25.0, peers, {.octree = 1.0});
    add(session, "memory.hot.bytes_per_run", bytes, runs, 8.5, peers, {.octree = 1.0});
    packedFigures(session, "memory.packed.bytes_per_run.new", snapshot, 0.6, peers,
                  {.bytes = 1000.0, .bits = 100.0, .openVdb = 30.0, .octree = 1.0});
}

void finishedFreeform(Session& session) {
    session.stage("memory, a finished freeform of 2048 x 2048 x 2048");
    RunVolume volume = scallopedFreeform(2048);
    const VolumeSnapshot snapshot = volume.snapshot();
    packedFigures(session, "memory.packed.bytes_per_run.freeform", snapshot, 0.9, peerSizes(session, snapshot), {});
}

void milledBlock(Session& session) {
    session.stage("memory, after heavy milling at 1024 x 1024 x 1024");
    RunVolume volume = layeredBlock(1024);
    millHeavily(session, volume, 5000);
    const VolumeSnapshot snapshot = volume.snapshot();
    packedFigures(session, "memory.packed.bytes_per_run.milled", snapshot, 1.3, peerSizes(session, snapshot), {});
}

} // namespace

void memoryFigures(Session& session) {
    if (session.wants("memory.hot") || session.wants("memory.packed.bytes_per_run.new")) newBlock(session);
    if (session.wants("memory.packed.bytes_per_run.freeform")) finishedFreeform(session);
    if (session.wants("memory.packed.bytes_per_run.milled")) milledBlock(session);
}

} // namespace burin::benchmarks
