// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/part_faces.h"
#include "core/verify/deviation_map.h"

#include <span>
#include <string>
#include <vector>

namespace burin {

/// The point of a face with the greatest deviation of one kind.
struct WorstPoint {
    double amount = 0.0;     ///< mm, >= 0
    glm::dvec3 place{0.0};   ///< mm, setup frame, on the part
    glm::dvec3 outward{0.0}; ///< unit normal of the part there
};

/// The inspection result of one face of a part.
struct FaceQuality {
    std::size_t number = 0; ///< in the order of partFaces, from 1
    MeasuredFace::Kind kind = MeasuredFace::Kind::other;
    double radius = 0.0;     ///< mm, as in PartFacePatch
    double area = 0.0;       ///< mm²
    std::size_t samples = 0; ///< that lie on it; 0: smaller than their spacing, so nothing is known of the face
    WorstPoint gouge;        ///< the deepest gouge; 0: none is deeper than the tolerance
    WorstPoint excess;       ///< most stock beyond the allowance among reachable points; 0: none
    WorstPoint middle;       ///< centroid of its largest triangle; the amount is 0
    /// Shares of its samples. The share of gouges is a lower bound: each tool position marks only one sample.
    DeviationMap::Shares shares;
};

/// Assigns each sample to the face with the nearest triangle and returns the result of each face, in the order of the
/// faces. Runs on all cores.
/// @param faces of the part, in the frame of the samples
/// Errors: cancelled.
Result<std::vector<FaceQuality>> faceQualities(std::span<const PartFacePatch> faces,
                                               std::span<const DeviationSample> samples,
                                               const DeviationTolerance& tolerance, Progress& progress);

/// Sorts the worst faces first: by the deepest gouge, then the most stock, then the smallest share within tolerance;
/// faces without samples come last.
void sortByQuality(std::vector<FaceQuality>& faces);

/// Returns the point at which to show a face: its gouge, without one its excess, otherwise its middle.
const WorstPoint& worstPointOf(const FaceQuality& face) noexcept;

/// Returns a header line with names and units, then a line for each face; positions in the setup frame. Numbers have a
/// decimal point whatever the locale; fields that are unknown or don't apply are empty.
/// @param separator between fields: a comma (CSV), or a tab (for pasting into spreadsheets)
std::string faceTable(std::span<const FaceQuality> faces, char separator);

} // namespace burin
