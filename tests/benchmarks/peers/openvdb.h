// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle_mesh.h"
#include "tests/benchmarks/peers/cutting_peer.h"

#include <array>
#include <optional>
#include <vector>

namespace burin::benchmarks {

// OpenVDB as a peer. In a build of Burin without OpenVDB these functions return null.

bool hasOpenVdb() noexcept;

/// Bytes of a pruned tree of one byte per voxel (properties) with a volume's whole-voxel view.
std::optional<std::uint64_t> openVdbBytes(const VolumeSnapshot& volume);

/// Such a tree, milled by writing to its leaves what the previous pose did not reach, each leaf looked up once per
/// column of 8 × 8 lines. Null without OpenVDB.
std::unique_ptr<CuttingPeer> openVdbCutter(const VolumeSnapshot& workpiece, const EndMill& tool);

/// The time of each move, µs: a level-set sphere at its end is subtracted from a level-set block of `side` voxels by
/// csgDifference. Half bandwidth 3.
std::optional<std::vector<double>> csgDifferenceTimes(double side, double radius, const std::vector<glm::dvec3>& tips);

/// The time that tools::meshToLevelSet takes for a mesh, s. @param halfWidth  voxels of 1 mm
std::optional<double> meshToLevelSetSeconds(const TriangleMesh& mesh, float halfWidth);

/// Times of csgUnionCopy, csgIntersectionCopy and csgDifferenceCopy of the level sets (voxels of 1 mm, half bandwidth
/// 3) of two blocks, ms; the least of several runs.
std::optional<std::array<double, 3>> levelSetBooleanTimes(const Box& a, const Box& b, int runs);

/// Time of a trilinear look-up (BoxSampler, only the value) in the level set (half bandwidth 4) of a mesh, ns.
std::optional<double> levelSetQueryNanoseconds(const TriangleMesh& mesh, const std::vector<glm::dvec3>& places);

} // namespace burin::benchmarks
