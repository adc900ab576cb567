// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <openvdb/openvdb.h>

namespace burin::benchmarks {

/// One property per voxel; air is inactive background. x, y, z of the tree are u, v and the position along the runs.
using PropertyTree = openvdb::tree::Tree4<std::int8_t, 5, 4, 3>::Type;

/// The whole-voxel view of a volume; uniform cubes of all sizes are tiles. The grid's counts must be multiples of 8.
PropertyTree::Ptr propertyTree(const VolumeSnapshot& volume);

} // namespace burin::benchmarks
