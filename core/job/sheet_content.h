// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"
#include "core/job/program_job.h"

#include <memory>
#include <string>
#include <vector>

namespace burin {

/// What a project says of the setup in use, for its sheet.
struct SheetSource {
    std::string project;                ///< file name, without its folder
    std::string setupName;              ///< setupTitle
    std::shared_ptr<const Model> model; ///< as it lies in the setup
    Setup setup;
    std::vector<Property> materials; ///< that the project keeps
    std::vector<Obstacle> obstacles; ///< fixtures and keep-out volumes, bodies that are fixtures among them
    AxisMode axis;
    MachineProfile machine;
    std::string dialect;
    NcUnits units = NcUnits::millimetre;
    std::shared_ptr<const CheckedProgram> program; ///< null: none was checked
    bool programUpToDate = false;                  ///< its verdict holds for the project as it is
    std::string programName;                       ///< as it was exported last; empty: it was not
    std::vector<Tool> tools; ///< that the program calls; those of the recordings where there is none
};

/// With what is made of it in seconds.
struct SheetContent {
    SheetSource source;
    VolumeSnapshot stock; ///< before anything is milled
    std::vector<MaterialAmount> amounts;
};

/// Reads it. Errors: projectIncomplete (no stock yet), fileDamaged, those of loadMachine.
Result<SheetSource> sheetSource(const Project& project, const std::string& file);
/// Embeds its stock. Any thread. Errors: those of embed, cancelled.
Result<SheetContent> sheetContent(SheetSource source, Progress& progress);

} // namespace burin
