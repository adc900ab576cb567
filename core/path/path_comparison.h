// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/number_range.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/path/path.h"

#include <optional>
#include <vector>

namespace burin {

/// Lengths, counts and time of a path. Arcs count with their arc length.
struct PathTotals {
    double cutting = 0.0;  ///< mm, of cuts
    double plunging = 0.0; ///< mm, of plunges
    double air = 0.0;      ///< mm, of rapids and retracts
    std::size_t points = 0, arcs = 0;
    /// s, for all moves at feed, at exactly their feeds; empty if some have no feed yet
    std::optional<double> feedTime{};
};
PathTotals totalsOf(const Path& path);

/// The distance of the cuts of a path from those of another one. Evaluated at every point and, between points, every
/// `comparedSpacing`; between two such positions the distance is greater by at most half of that.
struct PathDeviation {
    double largest = 0.0;      ///< mm
    glm::dvec3 largestAt{0.0}; ///< mm, setup frame, on the evaluated path
    double mean = 0.0;         ///< mm, along the length of its cuts
    double length = 0.0;       ///< mm, of its cuts
    double farther = 0.0;      ///< mm, of the cuts that are farther away than the tolerance
    /// These parts as polylines, mm, setup frame, in the order of the path. A part of zero length is a single point.
    std::vector<std::vector<glm::dvec3>> fartherParts;

    double fartherShare() const noexcept { return length > 0.0 ? farther / length : 0.0; }
};

inline constexpr double comparedSpacing = 0.05; ///< mm
inline constexpr double comparedChord = 0.001;  ///< mm, deviation of chords from arcs, on both paths
inline constexpr double usualComparedTolerance = 0.01;
inline constexpr NumberRange comparedTolerances{0.0001, 1000.0}; ///< mm

/// The comparison of two paths.
struct PathDifference {
    double tolerance = 0.0; ///< mm
    PathTotals first, second;
    /// Deviation of the cuts of the first path from those of the second, and vice versa; empty if either has no cuts.
    std::optional<PathDeviation> ofFirst, ofSecond;
};

/// Compares only moves of the kind `cut`: plunges, retracts and rapids lead to them, and depend on the links.
/// Thread-safe; runs on all cores, the result does not depend on their number. Cost: about 1 s for 50 m of cuts on two
/// cores. Cancellable. Errors: argumentInvalid (a tolerance out of `comparedTolerances`), cancelled.
Result<PathDifference> differenceOf(const Path& first, const Path& second, double tolerance, Progress& progress);

} // namespace burin
