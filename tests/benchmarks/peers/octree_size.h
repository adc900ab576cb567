// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

namespace burin::benchmarks {

/// Bytes of a volume's octree with 8 bytes per node, counted exactly from its runs without building it. The most
/// compact form: a node refers to its eight children by one position and a mask, a uniform cube is a node with its
/// property, and a mixed cube of 2 × 2 × 2 voxels is one node with their eight properties. The grid must be a cube
/// whose side is a power of two.
std::uint64_t octreeBytes(const VolumeSnapshot& volume);

} // namespace burin::benchmarks
