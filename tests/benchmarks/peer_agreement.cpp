// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/dense.h"
#include "tests/benchmarks/figure_groups.h"
#include "tests/benchmarks/measure/milling.h"
#include "tests/benchmarks/peers/openvdb.h"
#include "tests/benchmarks/scenes/cutting_scene.h"
#include "tests/benchmarks/scenes/tool_paths.h"

namespace burin::benchmarks {

namespace {

constexpr std::int32_t side = 128;
constexpr double radius = 16.0;

/// Voxels of a peer after it has milled a path, x fastest.
std::vector<PropertyIndex> milledBy(CuttingPeer& peer, const std::vector<glm::dvec3>& tips, VoxelCounts& removed) {
    peer.restart();
    peer.cut(tips.front(), tips.front(), removed);
    for (std::size_t i = 0; i + 1 < tips.size(); ++i) peer.cut(tips[i], tips[i + 1], removed);
    std::vector<PropertyIndex> voxels;
    for (std::int32_t k = 0; k < side; ++k)
        for (std::int32_t j = 0; j < side; ++j)
            for (std::int32_t i = 0; i < side; ++i) voxels.push_back(peer.at({i, j, k}));
    return voxels;
}

std::vector<PropertyIndex> milledByUs(Session& session, RunVolume& workpiece, const std::vector<glm::dvec3>& tips) {
    Milling milling(workpiece, cutterOf(CutterType::ball, radius));
    const std::vector<ToolPose> path = upright(tips);
    milling.restart(session, path.front());
    for (std::size_t i = 0; i + 1 < path.size(); ++i) milling.tick(path[i], path[i + 1]);
    milling.finish(session);
    return toDense(workpiece.snapshot());
}

} // namespace

/// Before anything is timed: the paper's way, dense bytes, dense bits and OpenVDB give the very same voxels, and those
/// of the runs, seen as whole voxels, are the same but where the face passes a voxel's centre within the exact sweep's
/// distance from poses half a voxel apart (s² / 8R = 0.002 voxel) and a run end's rounding (1/512 voxel).
void peersAgree(Session& session) {
    if (!session.wants("peers") && !session.wants("cut.")) return;
    session.stage("the peers cut alike");
    RunVolume workpiece = layeredBlock(side);
    const VolumeSnapshot start = workpiece.snapshot();
    const std::vector<PropertyIndex> before = toDense(start);
    // The whole grid: what lies outside of the way is compared as well.
    const LineBlock block{{0, 0}, {side - 1, side - 1}};
    const std::vector<glm::dvec3> tips = walk(side, radius, 1.0, 400);

    VoxelCounts removedByPaper{};
    const auto paper = milledBy(*paperCutter(start, block, radius), tips, removedByPaper);
    const auto agrees = [&](std::unique_ptr<CuttingPeer> peer, const std::string& name, bool materials) {
        if (!peer) return;
        VoxelCounts removed{};
        const auto voxels = milledBy(*peer, tips, removed);
        std::size_t different = 0;
        for (std::size_t i = 0; i < voxels.size(); ++i)
            different += materials ? voxels[i] != paper[i] : (voxels[i] != 0) != (paper[i] != 0);
        session.check(different == 0,
                      name + " leaves the same voxels as the paper's way (" + std::to_string(different) + " differ)");
        std::uint64_t sum = 0, paperSum = 0;
        for (std::size_t i = 1; i < removed.size(); ++i) {
            session.check(!materials || removed[i] == removedByPaper[i], name + " counts what it takes by material");
            sum += removed[i];
            paperSum += removedByPaper[i];
        }
        session.check(sum == paperSum, name + " counts what it takes");
    };
    agrees(denseByteCutter(start, block, radius), "dense bytes", true);
    agrees(denseBitCutter(start, block, radius), "dense bits", false);
    agrees(openVdbCutter(start, radius), "OpenVDB", true);

    const auto ours = milledByUs(session, workpiece, tips);
    std::size_t removed = 0, different = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        removed += before[i] != paper[i] ? 1U : 0U;
        different += ours[i] != paper[i] ? 1U : 0U;
    }
    const double share = 100.0 * static_cast<double>(different) / static_cast<double>(removed);
    constexpr double most = 0.5; // %
    session.add(figure("peers.differing_voxels", share, "%", most));
    session.check(share <= most,
                  "the runs lose the voxels that the peers lose but for " + std::to_string(share) + " %");
}

} // namespace burin::benchmarks
