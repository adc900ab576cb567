// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

namespace burin::benchmarks {

/// Bytes of a volume's octree with 8 bytes a node, counted exactly from its runs without building it. The most compact
/// form: a node names its eight children by one place and a mask, a uniform cube is a node that holds its property, and
/// a mixed cube of 2 × 2 × 2 voxels is one node that holds their eight properties. The grid must be a cube of a power
/// of two.
std::uint64_t octreeBytes(const VolumeSnapshot& volume);

} // namespace burin::benchmarks
