// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/part_measure.h"
#include "core/geometry/mesh_distance.h"
#include "core/volume/runs/run_volume.h"

#include <optional>
#include <string>

namespace burin {

/// A length with a bound of its deviation from the cut that made the workpiece, which follows from the voxels. mm.
struct MeasuredLength {
    double value = 0.0;
    double within = 0.0; ///< to either side
};

/// A workpiece, measured at a point of its surface. Setup frame.
struct MeasuredWorkpiece {
    /// The plane, cylinder or sphere fitted to the surface there (fitted_face.h), otherwise `other`; without area.
    /// `thickness` is that against the normal; `corner` is `place`.
    MeasuredFace face;
    double within = 0.0;       ///< mm: bound of `place` along the normal
    double radiusWithin = 0.0; ///< mm; 0 if there is no radius
    double angleWithin = 0.0;  ///< rad, of normal or axis
    /// Bound of `thickness`, mm; 0 without it.
    double thicknessWithin = 0.0;
    /// From the surface along the requested direction to where the material ends; empty: none was requested, or it
    /// leads out of the workpiece at once.
    std::optional<MeasuredLength> along{};
    /// From the surface outwards along the normal to other material: the width of a slot, the diameter of a hole. Empty
    /// if nothing is there.
    std::optional<MeasuredLength> opening{};
    double depth = 0.0; ///< mm below the top of the stock's box; its uncertainty is that of z
    double depthWithin = 0.0;
    /// mm, from the part: the stock that is left there; negative: cut into the part. Empty without a part.
    std::optional<double> fromPart{};
    std::string material; ///< id
};

/// Two points of a workpiece, or one.
struct WorkpieceMeasure {
    MeasuredWorkpiece from;
    std::optional<MeasuredWorkpiece> to{};
    std::optional<MeasuredPair> pair{}; ///< present if there is `to`; faces count as parallel within `angleWithin`
    double pairWithin = 0.0;            ///< mm: bound of the distances
    double angleWithin = 0.0;           ///< rad: bound of the angle
};

/// What a workpiece is measured against.
struct WorkpieceReference {
    const MeshDistance* part = nullptr; ///< null: none
    double stockTop = 0.0;              ///< mm, setup frame: the highest z of the stock's box
};

/// Where a workpiece is measured.
struct WorkpiecePoint {
    glm::dvec3 place{0.0};                 ///< mm, setup frame; the nearest point of the surface counts
    std::optional<glm::dvec3> direction{}; ///< of any length but 0: the thickness along it is measured, too
};

/// Measures a workpiece at a point or two. Any thread; takes some tenths of a second.
/// Errors: argumentInvalid (a point or direction that is not finite, a workpiece without material), cancelled.
Result<WorkpieceMeasure> measureWorkpiece(const VolumeSnapshot& workpiece, const WorkpieceReference& reference,
                                          const WorkpiecePoint& from, const std::optional<WorkpiecePoint>& to,
                                          Progress& progress);

} // namespace burin
