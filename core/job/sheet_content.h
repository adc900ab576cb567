// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"
#include "core/job/program_job.h"
#include "core/setup/fixture_fit.h"

#include <memory>
#include <string>
#include <vector>

namespace burin {

/// The data of a project about the setup in use, for its setup sheet.
struct SheetSource {
    std::string project;                ///< file name, without its folder
    std::string setupName;              ///< setupTitle
    std::shared_ptr<const Model> model; ///< in the setup frame
    Setup setup;
    std::vector<Property> materials; ///< stored in the project
    std::vector<Obstacle> obstacles; ///< fixtures and keep-out volumes, including bodies that are fixtures
    AxisMode axis;
    MachineProfile machine;
    std::string dialect;
    NcUnits units = NcUnits::millimetre;
    std::shared_ptr<const CheckedProgram> program; ///< null: none was checked
    bool programUpToDate = false;                  ///< its verdict holds for the present project
    std::string programName;                       ///< of the last export; empty: not exported
    std::vector<Tool> tools; ///< called by the program; without a program, those of the recordings
};

/// The source together with the data computed from it, which takes seconds.
struct SheetContent {
    SheetSource source;
    VolumeSnapshot stock; ///< before anything is milled
    std::vector<MaterialAmount> amounts;
    std::vector<BadFit> badFits; ///< fixtures that do not fit the stock
};

/// Reads the source. Errors: projectIncomplete (no stock yet), fileDamaged, those of loadMachine.
Result<SheetSource> sheetSource(const Project& project, const std::string& file);
/// Embeds the stock. Thread-safe. Errors: those of embed, cancelled.
Result<SheetContent> sheetContent(SheetSource source, Progress& progress);

} // namespace burin
