// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/volume/run_volume.h"

namespace burin {

/// How two objects lie to each other (Chen & Yang 2004, section 4.3).
enum class SpatialRelation : std::uint8_t {
    intersecting, ///< they share some of the space
    adjacent,     ///< they share none, but runs touch: on one scanline or on neighbouring ones (26-neighbourhood)
    separate,
};

/// Relation of two objects on the same grid. Run ends are taken as they are, to 1/256 voxel; for whole voxels this is
/// the paper's own definition. Parallel. Error: argumentInvalid (the grids differ).
Result<SpatialRelation> relation(const VolumeSnapshot& a, const VolumeSnapshot& b);

/// Relation of two entries of one volume's property list, which never intersect: adjacent or separate.
SpatialRelation relation(const VolumeSnapshot& volume, PropertyIndex a, PropertyIndex b);

} // namespace burin
