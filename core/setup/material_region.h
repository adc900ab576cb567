// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/geometry/box.h"
#include "core/volume/operations/grading.h"
#include "core/volume/runs/property_list.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// How one value of a region's material varies with position.
struct RegionGrade {
    std::string value = std::string(specificCuttingEnergy); ///< name of the material's value
    std::string formula; ///< of X, Y and Z, mm, setup frame, in the value's unit; empty: the table applies
    int axis = 2;        ///< of the table: 0, 1, 2 for x, y, z
    std::vector<Grading::Control> table; ///< position along that axis (mm, setup frame, increasing) and value
    int entries = 8; ///< bands of equal height that the values are sorted into, 1 … `maximumGrades`

    friend bool operator==(const RegionGrade& one, const RegionGrade& other);
};
inline constexpr int maximumGrades = 24;

/// A layer of the stock, between two planes perpendicular to an axis, with its own or a graded material. Where layers
/// overlap, the later one in the list takes precedence; inserts take precedence over layers, and the part over
/// everything.
struct MaterialRegion {
    std::string name;                                       ///< not empty, unique in a setup
    std::string material;                                   ///< id
    int axis = 2;                                           ///< normal of the planes: 0, 1, 2 for x, y, z
    double from = -std::numeric_limits<double>::infinity(); ///< mm, setup frame; infinite: unbounded on that side
    double to = std::numeric_limits<double>::infinity();
    std::optional<RegionGrade> grade; ///< empty: one material throughout

    friend bool operator==(const MaterialRegion&, const MaterialRegion&) = default;
};

/// Checks regions on their own, before any volume is made.
/// Errors: argumentInvalid (subject: the region's name; place: the offending field; detail: what is allowed).
Result<void> checkRegions(const std::vector<MaterialRegion>& regions);

/// Returns the values of a grade as a function of position. The result's `low` and `high` are the smallest and largest
/// value within `within`, sampled at the corners of cells of edge `step`. Errors: those of checkRegions,
/// argumentInvalid (a value that is not finite, with its position; a value that does not change).
/// @param within mm, setup frame @param step mm
Result<Grading> gradingOf(const MaterialRegion& region, const Box& within, double step);

} // namespace burin
