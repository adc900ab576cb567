// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"
#include "core/job/milling_context.h"
#include "core/job/program_job.h"

#include <string>

namespace burin {

/// The workpiece as one setup leaves it, the stock of another.
struct LeftStock {
    StockVolume::Shared volume; ///< in the other setup's frame
    Box box;                    ///< mm, that frame: around the material
    LeftBy by;
    bool byProgram = false; ///< as the setup's checked program leaves it; else as its recordings do
    /// mm by which its faces may lie beside the moved ones (MovedVolume::greatestDisplacement).
    double greatestDisplacement = 0.0;
};

/// A workpiece as it stands, as it lies where the part's placement is another. Any thread; some tenths of a second.
/// @param milling that `left` is the workpiece of @param by the setup that leaves it @param name for people
/// Errors: nameUnknown, resourceInvalid (a material), those of moved and StockVolume::of.
Result<LeftStock> leftStock(const MillingContext& milling, const VolumeSnapshot& left, const LeftBy& by,
                            const Placement& to, const std::string& name, Progress& progress);

/// The workpiece as a program that was checked leaves it. Errors: those of checkProgram.
Result<VolumeSnapshot> leftByProgram(const MillingContext& milling, const CheckedProgram& program, Progress& progress);

/// What stands of the stock behind a setup's checked program, as long as that holds, or else behind its recordings, as
/// it lies where a part's placement is another. Any thread; seconds. The project is used in its present setup again
/// afterwards. What lay on a face of a box stays on it exactly, across the runs as well, where the placement is along
/// axes.
/// Errors: nameUnknown, projectIncomplete (nothing was milled there), those of makeMillingContext, replayTakes,
/// checkProgram, moved and StockVolume::of.
Result<LeftStock> leftStock(Project& project, SetupId setup, const Placement& to, Progress& progress);

/// A setup with that stock. What it says of form and margins goes.
Setup withStock(Setup setup, const LeftStock& stock);

/// A part turned or moved further, and a stock that another setup left with it; any other stock stays where it is.
/// Errors: those of moved and StockVolume::of.
Result<Setup> placedFurther(Setup setup, const Placement& by, Progress& progress);

} // namespace burin
