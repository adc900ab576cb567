// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle_mesh.h"
#include "tests/benchmarks/peers/cutting_peer.h"

#include <array>
#include <optional>
#include <vector>

namespace burin::benchmarks {

// OpenVDB as a peer. A Burin that was built without it has no such peer: the functions answer nothing.

bool hasOpenVdb() noexcept;

/// Bytes of a tree of one byte a voxel (properties), pruned, that holds a volume's whole-voxel view.
std::optional<std::uint64_t> openVdbBytes(const VolumeSnapshot& volume);

/// Such a tree, milled by writing to its leaves what the pose before did not reach, each leaf looked up once a column
/// of 8 × 8 lines. Null without OpenVDB.
std::unique_ptr<CuttingPeer> openVdbCutter(const VolumeSnapshot& workpiece, const EndMill& tool);

/// µs of each move: a level-set sphere at its end, taken from a level-set block of side voxels by csgDifference. Half
/// bandwidth 3.
std::optional<std::vector<double>> csgDifferenceTimes(double side, double radius, const std::vector<glm::dvec3>& tips);

/// s that tools::meshToLevelSet takes for a mesh. @param halfWidth voxels of 1 mm
std::optional<double> meshToLevelSetSeconds(const TriangleMesh& mesh, float halfWidth);

/// ms of csgUnionCopy, csgIntersectionCopy, csgDifferenceCopy of the level sets (voxels of 1 mm, half bandwidth 3) of
/// two blocks; the least of some runs.
std::optional<std::array<double, 3>> levelSetBooleanTimes(const Box& a, const Box& b, int runs);

/// ns of a trilinear look-up (BoxSampler, the value alone) in the level set (half bandwidth 4) of a mesh.
std::optional<double> levelSetQueryNanoseconds(const TriangleMesh& mesh, const std::vector<glm::dvec3>& places);

} // namespace burin::benchmarks
