// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/volume/runs/run_volume.h"

namespace burin {

/// How two objects lie to each other (Chen & Yang 2004, section 4.3). A run stands for a closed box, one voxel across
/// and from its start to its end along the scanline; an object is all of its boxes.
enum class SpatialRelation : std::uint8_t {
    /// Boxes share some of the space: runs overlap on one scanline, by 1/256 voxel at least.
    intersecting,
    /// They share none, but a face, an edge or a corner: runs meet on one scanline, or meet or overlap on two
    /// neighbouring ones (8 around each).
    adjacent,
    /// A gap of 1/256 voxel along the scanlines is enough, or one scanline between.
    separate,
};

/// Relation of two objects on the same grid. Run ends are taken as they are, to 1/256 voxel; for whole voxels this is
/// the paper's own definition: a common voxel, or one among the other's 26 neighbours. Symmetric; air alone is separate
/// from everything. Parallel. Error: argumentInvalid (the grids differ).
Result<SpatialRelation> relation(const VolumeSnapshot& a, const VolumeSnapshot& b);

/// Relation of two entries of one volume's property list, which never intersect: adjacent or separate.
SpatialRelation relation(const VolumeSnapshot& volume, PropertyIndex a, PropertyIndex b);

} // namespace burin
