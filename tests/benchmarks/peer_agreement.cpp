// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/dense.h"
#include "tests/benchmarks/figure_groups.h"
#include "tests/benchmarks/measure/milling.h"
#include "tests/benchmarks/peers/openvdb.h"
#include "tests/benchmarks/scenes/cutting_scene.h"
#include "tests/benchmarks/scenes/tool_paths.h"

#include <algorithm>

namespace burin::benchmarks {

namespace {

constexpr std::int32_t side = 128;
constexpr double radius = 16.0;

/// The voxels of a peer after it has milled a path, x fastest.
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

/// The voxels of a small cube of material after a tool has moved through it, found voxel by voxel at poses an eighth of
/// a voxel apart: what the tool removes with any axis, in any direction of the runs.
std::vector<PropertyIndex> milledVoxelByVoxel(const Cutter& cutter, const std::vector<ToolPose>& path,
                                              std::int32_t cube) {
    std::vector<ToolPose> poses;
    constexpr int between = 8;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        for (int part = 0; part <= between; ++part) {
            const double share = static_cast<double>(part) / between;
            poses.push_back({glm::mix(path[i].tip, path[i + 1].tip, share),
                             glm::normalize(glm::mix(path[i].axis, path[i + 1].axis, share))});
        }
    const RevolvedPiece flutes = burin::flutes(cutter);
    std::vector<PropertyIndex> voxels;
    for (std::int32_t k = 0; k < cube; ++k)
        for (std::int32_t j = 0; j < cube; ++j)
            for (std::int32_t i = 0; i < cube; ++i) {
                const bool inside = std::ranges::any_of(poses, [&](const ToolPose& pose) {
                    const glm::dvec3 offset = glm::dvec3(i, j, k) + 0.5 - pose.tip;
                    const double height = glm::dot(offset, pose.axis);
                    return signedDistance(flutes, glm::length(offset - height * pose.axis), height) < 0.0;
                });
                voxels.push_back(inside ? airProperty : PropertyIndex{1});
            }
    return voxels;
}

constexpr std::int32_t cube = 48;
constexpr double reach = 9.0, tilt = 0.5;

/// For tilted tools there is no peer worth timing. That they remove the right voxels is checked nevertheless, as it is
/// for runs across the spindle.
void axisIsRight(Session& session, CutterType type, const std::vector<ToolPose>& path, RunAxis axis) {
    constexpr double most = 0.01; // as a share of what is removed: voxels whose centres are almost exactly on the face
    const Cutter cutter = cutterOf(type, reach);
    SlotStock stock;
    stock.extent = glm::ivec3(cube);
    stock.axis = axis;
    stock.top = cube;
    RunVolume workpiece = slotStock(stock);
    Milling milling(workpiece, cutter);
    milling.restart(session, path.front());
    for (std::size_t i = 0; i + 1 < path.size(); ++i) milling.tick(path[i], path[i + 1]);
    milling.finish(session);
    const auto ours = toDense(workpiece.snapshot()), exact = milledVoxelByVoxel(cutter, path, cube);
    std::size_t removed = 0, different = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        removed += exact[i] == airProperty ? 1U : 0U;
        different += ours[i] != exact[i] ? 1U : 0U;
    }
    const double share = static_cast<double>(different) / static_cast<double>(removed);
    session.check(share <= most, "a tool of type " + std::to_string(static_cast<int>(type)) + " leaning by " +
                                     std::to_string(std::acos(path.front().axis.z)) + " rad, runs along " +
                                     (axis == RunAxis::z ? "z" : "x") + ", takes the voxels that it covers (" +
                                     std::to_string(100.0 * share) + " % differ)");
}

} // namespace

/// Called before the figures of tilted tools and of runs across the spindle are measured.
void axesAreRight(Session& session) {
    bool wanted = session.wants("ripple.");
    for (const char* name : {"cut.ball.r50.tilt30", "cut.flat.r50.tilt30", "cut.bull.r50.tilt30"})
        wanted = wanted || session.wants(name);
    if (!wanted) return;
    session.stage("any axis is right");
    std::vector<glm::dvec3> tips = walk(cube, reach, 1.0, 8);
    for (const CutterType type : {CutterType::ball, CutterType::flat, CutterType::bullNose})
        for (const bool tilts : {true, false})
            for (const RunAxis axis : {RunAxis::z, RunAxis::x})
                axisIsRight(session, type, tilts ? tilted(tips, tilt) : upright(tips), axis);
}

/// Called before anything is timed. The paper's method, dense bytes, dense bits and OpenVDB give exactly the same
/// voxels. Those of the runs, seen as whole voxels, are the same except where the face passes a voxel's centre within
/// the difference between the exact sweep and poses half a voxel apart (s² / 8R = 0.002 voxel) plus the rounding of a
/// run end (1/512 voxel).
void peersAgree(Session& session) {
    if (!session.wants("peers") && !session.wants("cut.")) return;
    session.stage("all cut alike");
    RunVolume workpiece = layeredBlock(side);
    const VolumeSnapshot start = workpiece.snapshot();
    const std::vector<PropertyIndex> before = toDense(start);
    // The whole grid, so that the region outside the path is compared as well.
    const LineBlock block{{0, 0}, {side - 1, side - 1}};
    const std::vector<glm::dvec3> tips = walk(side, radius, 1.0, 400);

    const EndMill tool = endMillOf(cutterOf(CutterType::ball, radius));

    VoxelCounts removedByPaper{};
    const auto paper = milledBy(*paperCutter(start, block, tool), tips, removedByPaper);
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
    agrees(denseByteCutter(start, block, tool), "dense bytes", true);
    agrees(denseBitCutter(start, block, tool), "dense bits", false);
    agrees(openVdbCutter(start, tool), "OpenVDB", true);

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
