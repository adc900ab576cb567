// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/volume/runs/run_volume.h"

namespace burin {

/// Spatial relation of two objects (Chen & Yang 2004, section 4.3). A run represents a closed box, one voxel wide
/// across the scanline and from its start to its end along it; an object is the union of its boxes.
enum class SpatialRelation : std::uint8_t {
    /// The interiors of boxes overlap: runs overlap on one scanline, by at least 1/256 voxel.
    intersecting,
    /// Only a face, an edge or a corner is shared: runs touch on one scanline, or touch or overlap on two neighbouring
    /// ones (8 around each).
    adjacent,
    /// There is a gap: 1/256 voxel along the scanlines is enough, or one scanline between.
    separate,
};

/// Relation of two objects on the same grid. Run ends are used as they are, to 1/256 voxel; for whole voxels this is
/// the paper's own definition: a common voxel, or one among the other's 26 neighbours. Symmetric; air alone is separate
/// from everything. Parallel. Errors: argumentInvalid (the grids differ).
Result<SpatialRelation> relation(const VolumeSnapshot& a, const VolumeSnapshot& b);

/// Relation of two entries of one volume's property list, which never intersect: adjacent or separate.
SpatialRelation relation(const VolumeSnapshot& volume, PropertyIndex a, PropertyIndex b);

} // namespace burin
