// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/surface_fit.h"
#include "core/volume/runs/run_volume.h"

#include <optional>

namespace burin {

/// The face of a workpiece at a point of its surface, mm, setup frame. All uncertainties are bounds to either side
/// that follow from the voxels.
struct FittedFace {
    glm::dvec3 place{0.0};  ///< on the face, nearest to the requested one
    glm::dvec3 normal{0.0}; ///< unit, outwards
    /// The plane, cylinder or sphere that explains most of the surface around; empty: a free-form face.
    std::optional<FittedSurface> surface;
    double within = 0.0;       ///< mm, of `place` along the normal: see `surfaceUncertainty`
    double radiusWithin = 0.0; ///< mm; 0 for a plane or a free-form face
    double angleWithin = 0.0;  ///< rad, of the plane's normal or the cylinder's axis; 0 for others
};

/// Fits the surface around a point: the part of it that is connected and within 60 voxels. A surface is fitted to the
/// points nearest to the given one, then extended step by step to the connected points that agree with it (no farther
/// than 0.75 voxel, normal within 35°), as region growing in reverse engineering does it (Várady, Martin & Cox 1997,
/// Computer-Aided Design 29, 255-268).
/// @return empty if the workpiece is all air, or the point is not finite
/// Cost     below a second.
std::optional<FittedFace> fittedFaceAt(const VolumeSnapshot& workpiece, const glm::dvec3& place);

/// mm: by how much a surface with this normal may deviate from the cut that made it: 1/200 voxel if it is perpendicular
/// to the runs, 0.05 voxel if it is inclined to that by up to 45°, else half a voxel.
double surfaceUncertainty(const Grid& grid, const glm::dvec3& normal) noexcept;

} // namespace burin
