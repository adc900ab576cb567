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

/// What a path comes to by itself. Arcs count with their own length.
struct PathTotals {
    double cutting = 0.0;  ///< mm, of cuts
    double plunging = 0.0; ///< mm, of plunges
    double air = 0.0;      ///< mm, of rapids and retracts
    std::size_t points = 0, arcs = 0;
    /// s, of all moves at feed, as fast as their feeds say; nothing: some have no feed yet
    std::optional<double> feedTime{};
};
PathTotals totalsOf(const Path& path);

/// How far the cuts of a path are from those of another one. Looked at in every point and, between points, every
/// `comparedSpacing`: what lies between two such places is farther by half of that at most.
struct PathDeviation {
    double largest = 0.0;      ///< mm
    glm::dvec3 largestAt{0.0}; ///< mm, setup frame, on the path that is looked at
    double mean = 0.0;         ///< mm, along the length of its cuts
    double length = 0.0;       ///< mm, of its cuts
    double farther = 0.0;      ///< mm of them that are farther than the tolerance
    /// These parts as lines, mm, setup frame, in the order of the path. A part of one place is a point alone.
    std::vector<std::vector<glm::dvec3>> fartherParts;

    double fartherShare() const noexcept { return length > 0.0 ? farther / length : 0.0; }
};

inline constexpr double comparedSpacing = 0.05; ///< mm
inline constexpr double comparedChord = 0.001;  ///< mm that chords leave arcs by, on either path
inline constexpr double usualComparedTolerance = 0.01;
inline constexpr NumberRange comparedTolerances{0.0001, 1000.0}; ///< mm

struct PathComparison {
    double tolerance = 0.0; ///< mm
    PathTotals first, second;
    /// Of the cuts of the first from those of the second, and the other way round; nothing where either cuts nothing.
    std::optional<PathDeviation> ofFirst, ofSecond;
};

/// Compares by moves of the kind `cut` alone: plunges, retracts and rapids lead to them, and depend on the links. Any
/// thread; shared among all cores, the result does not depend on them. Cost: about 2 s for 50 m of cuts on two cores.
/// Cancellable. Errors: argumentInvalid (a tolerance out of `comparedTolerances`), cancelled.
Result<PathComparison> comparePaths(const Path& first, const Path& second, double tolerance, Progress& progress);

} // namespace burin
