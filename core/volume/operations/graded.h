// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/operations/grading.h"
#include "core/volume/runs/run_volume.h"

#include <string>

namespace burin {

/// A material one value of which changes from place to place, as so many entries of a property list: entry k stands
/// where the value lies in the k-th of equally high bands, and bears the value in its band's middle. So no place is off
/// by more than `error`.
struct GradedMaterial {
    PropertyIndex base = airProperty; ///< what it is a grade of
    PropertyIndex first = airProperty;
    int entries = 0; ///< first … first + entries - 1, from the lowest value to the highest
    Grading grading;

    double bandHeight() const noexcept { return (grading.high() - grading.low()) / entries; }
    double error() const noexcept { return 0.5 * bandHeight(); }
    /// In the middle of a band, counted from 0.
    double valueOf(int band) const noexcept { return grading.low() + (band + 0.5) * bandHeight(); }
    int bandOf(double value) const noexcept;
};

/// Adds the grades of a material to a list, before the volume is made: "wax" becomes "wax (graded 1/8)" … "wax (graded
/// 8/8)", which differ in one value and a little in colour. A material is graded once.
/// @param valueName one of the material's values
/// Errors: argumentInvalid (no such value, less than 1 entry, a list that is full; some may have been added then).
Result<GradedMaterial> addGrades(PropertyList& list, PropertyIndex base, const std::string& valueName, Grading grading,
                                 int entries);

/// Turns the runs of the base material to its grades. Runs are split where the value crosses from band to band: each
/// 1/256 voxel gets the band of its middle. Parallel; cost: some 20 evaluations a split, for a function one a voxel
/// besides. Writer's thread, not for the haptic loop.
/// Errors: argumentInvalid (the volume's list has not these grades), outOfMemory, volumeOutOfMemory (some bricks are
/// graded then, others not; it may be called again).
Result<void> gradeRuns(RunVolume& volume, const GradedMaterial& material);

} // namespace burin
