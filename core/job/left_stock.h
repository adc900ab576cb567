// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"
#include "core/job/milling_context.h"
#include "core/job/program_job.h"

#include <string>

namespace burin {

/// The workpiece as left by one setup, used as the stock of another.
struct LeftStock {
    StockVolume::Shared volume; ///< in the other setup's frame
    Box box;                    ///< mm, same frame: around the material
    LeftBy by;
    bool byProgram = false; ///< left by the setup's checked program; otherwise by its recordings
    /// Largest distance between its faces and the exactly moved ones, mm (MovedVolume::greatestDisplacement).
    double greatestDisplacement = 0.0;
};

/// Returns a workpiece in its present state, moved to another placement of the part. Thread-safe; takes some tenths of
/// a second.
/// @param milling the context of the workpiece `left` @param by the setup that leaves it @param name for display
/// Errors: nameUnknown, resourceInvalid (a material), those of moved and StockVolume::of.
Result<LeftStock> leftStock(const MillingContext& milling, const VolumeSnapshot& left, const LeftBy& by,
                            const Placement& to, const std::string& name, Progress& progress);

/// Returns the workpiece as left by a checked program. Errors: those of checkProgram.
Result<VolumeSnapshot> leftByProgram(const MillingContext& milling, const CheckedProgram& program, Progress& progress);

/// Returns the stock left by a setup's checked program, if its verdict holds, or otherwise by its recordings, moved to
/// another placement of the part. Any thread; takes seconds. The project's setup in use is the same afterwards. If the
/// placement is along the axes, faces that lay on a face of a box stay exactly on it, also across the runs.
/// Errors: nameUnknown, projectIncomplete (nothing was milled there), those of makeMillingContext, replayTakes,
/// checkProgram, moved and StockVolume::of.
Result<LeftStock> leftStock(Project& project, SetupId setup, const Placement& to, Progress& progress);

/// Returns a setup with that stock, which replaces its form and margins.
Setup withStock(Setup setup, const LeftStock& stock);

/// Returns a setup whose part is turned or moved further, together with a stock left by another setup; any other stock
/// stays where it is.
/// Errors: those of moved and StockVolume::of.
Result<Setup> placedFurther(Setup setup, const Placement& by, Progress& progress);

} // namespace burin
