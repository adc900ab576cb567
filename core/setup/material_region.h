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

/// How one value of a region's material changes from place to place.
struct RegionGrade {
    std::string value = std::string(specificCuttingEnergy); ///< name of the material's value
    std::string formula; ///< of X, Y and Z, mm, setup frame, in the value's unit; empty: the table stands
    int axis = 2;        ///< of the table: 0, 1, 2 for x, y, z
    std::vector<Grading::Control> table; ///< along that axis: mm, setup frame, and the value there; rising
    int entries = 8;                     ///< equally high bands that the values are sorted into, 1 … `maximumGrades`

    friend bool operator==(const RegionGrade& one, const RegionGrade& other);
};
inline constexpr int maximumGrades = 24;

/// A layer of the stock, between two planes across an axis, that has a material of its own or a graded one. Where
/// layers overlap the later in the list has the place; inserts have it before any layer, and the part before all.
struct MaterialRegion {
    std::string name;                                       ///< not empty, each once in a setup
    std::string material;                                   ///< id
    int axis = 2;                                           ///< that the planes stand across: 0, 1, 2 for x, y, z
    double from = -std::numeric_limits<double>::infinity(); ///< mm, setup frame; infinite: no plane on that side
    double to = std::numeric_limits<double>::infinity();
    std::optional<RegionGrade> grade; ///< none: one material throughout

    friend bool operator==(const MaterialRegion&, const MaterialRegion&) = default;
};

/// What is wrong with regions by themselves, before any volume is made.
/// Errors: argumentInvalid (subject: the region's name; place: what of it; detail: what is allowed).
Result<void> checkRegions(const std::vector<MaterialRegion>& regions);

/// The values of a grade, as a function of the place. `low` and `high` are what it takes within `within`, looked at
/// at the corners of cells of `step`. Errors: those of checkRegions, argumentInvalid (a value that is not finite, with
/// its place; one that does not change).
/// @param within mm, setup frame @param step mm
Result<Grading> gradingOf(const MaterialRegion& region, const Box& within, double step);

} // namespace burin
