// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <span>
#include <vector>

namespace burin {

/// Constructs a volume from a voxel array: slices, lines and voxels are traversed, and a run begins where the property
/// changes (Chen & Yang 2004, section 2). Lossless: `toDense` returns the same array.
/// @param voxels  one property per voxel; x counts fastest, then y, then z
/// Errors: argumentInvalid (size of the array, or a property that is not in the list), outOfMemory, volumeOutOfMemory.
Result<RunVolume> fromDense(const Grid& grid, PropertyList properties, std::span<const PropertyIndex> voxels);

/// The voxel array of a volume in the same order; a voxel has the property at its centre.
std::vector<PropertyIndex> toDense(const VolumeSnapshot& volume);

} // namespace burin
