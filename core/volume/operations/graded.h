// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/operations/grading.h"
#include "core/volume/runs/run_volume.h"

#include <string>

namespace burin {

/// A material with one value that varies in space, represented by several entries of a property list: entry k is used
/// where the value lies in the k-th of equally high bands, and has the value of its band's middle. So the value is
/// nowhere off by more than `error`.
struct GradedMaterial {
    PropertyIndex base = airProperty; ///< the material that it is a grade of
    PropertyIndex first = airProperty;
    int entries = 0; ///< first … first + entries - 1, from the lowest value to the highest
    Grading grading;

    double bandHeight() const noexcept { return (grading.high() - grading.low()) / entries; }
    double error() const noexcept { return 0.5 * bandHeight(); }
    /// The value in the middle of a band, counted from 0.
    double valueOf(int band) const noexcept { return grading.low() + (band + 0.5) * bandHeight(); }
    int bandOf(double value) const noexcept;
};

/// Adds the grades of a material to a list, before the volume is made: "wax" becomes "wax (graded 1/8)" … "wax (graded
/// 8/8)", which differ in one value and slightly in colour. A material can be graded only once.
/// @param valueName one of the material's values
/// Errors: argumentInvalid (no such value, less than 1 entry, a full list; some grades may then have been added).
Result<GradedMaterial> addGrades(PropertyList& list, PropertyIndex base, const std::string& valueName, Grading grading,
                                 int entries);

/// Replaces the runs of the base material by runs of its grades. Runs are split where the value crosses from band to
/// band: each 1/256 voxel gets the band at its middle. Parallel; cost: some 20 evaluations per split, and for a
/// function also one per voxel. Writer's thread, not for the haptic loop.
/// Errors: argumentInvalid (the volume's list does not have these grades), outOfMemory, volumeOutOfMemory (some bricks
/// are then graded and others not; the function may be called again).
Result<void> gradeRuns(RunVolume& volume, const GradedMaterial& material);

} // namespace burin
