// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/part_faces.h"
#include "core/verify/deviation_map.h"

#include <span>
#include <string>
#include <vector>

namespace burin {

/// Where a face is off by the most.
struct WorstPoint {
    double amount = 0.0;     ///< mm, >= 0
    glm::dvec3 place{0.0};   ///< mm, setup frame, on the part
    glm::dvec3 outward{0.0}; ///< unit normal of the part there
};

/// How one face of a part came out.
struct FaceQuality {
    std::size_t number = 0; ///< in the order of partFaces, from 1
    MeasuredFace::Kind kind = MeasuredFace::Kind::other;
    double radius = 0.0;         ///< mm, as PartFacePatch has it
    double area = 0.0;           ///< mm²
    std::size_t samples = 0;     ///< that lie on it; 0: it is smaller than they are apart, and nothing is known of it
    WorstPoint gouge;            ///< the deepest; 0: none is deeper than the tolerance
    WorstPoint excess;           ///< most stock beyond the allowance where a tool could reach it; 0: none
    WorstPoint middle;           ///< of its largest triangle; the amount is 0
    DeviationMap::Shares shares; ///< of its samples
};

/// Gives each sample to the face whose triangles are nearest, and each face what its samples say; in the order of the
/// faces. All cores.
/// @param faces of the part, in the frame of the samples
/// Errors: cancelled.
Result<std::vector<FaceQuality>> faceQualities(std::span<const PartFacePatch> faces,
                                               std::span<const DeviationSample> samples,
                                               const DeviationTolerance& tolerance, Progress& progress);

/// The worst faces first: the deepest gouge, then the most stock, then the smaller share within tolerance; what is not
/// known at the end.
void sortByQuality(std::vector<FaceQuality>& faces);

/// Where to look at a face: its gouge, where it has none its stock, else its middle.
const WorstPoint& worstPointOf(const FaceQuality& face) noexcept;

/// A line for each face behind a line of names, which carry their unit; positions in the setup frame. Numbers have a
/// decimal point, whatever the locale; what is not known or not there is empty.
/// @param separator between fields: a comma (CSV), a tab (what spreadsheets paste)
std::string faceTable(std::span<const FaceQuality> faces, char separator);

} // namespace burin
