// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <span>
#include <vector>

namespace burin {

/// Construction of a volume from a voxel array: slices, lines and voxels are walked, a run begins where the property
/// changes (Chen & Yang 2004, section 2). Lossless: `toDense` gives the same array back.
/// @param voxels one property a voxel; x counts fastest, then y, then z
/// Errors: argumentInvalid (size of the array, a property that the list has not), outOfMemory, volumeOutOfMemory.
Result<RunVolume> fromDense(const Grid& grid, PropertyList properties, std::span<const PropertyIndex> voxels);

/// The voxel array of a volume, same order; a voxel has the property that its centre lies in.
std::vector<PropertyIndex> toDense(const VolumeSnapshot& volume);

} // namespace burin
