// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"
#include "core/volume/runs/run_volume.h"

#include <string>

namespace burin {

class CommandContext;

/// Which state of a project's workpiece.
struct WorkpieceChoice {
    bool stock = false; ///< before anything was milled
    std::string moment; ///< as for momentOf; empty: as the takes left it
};

/// The workpiece of the setup in use, as two stages of a command. Errors: those of makeMillingContext, momentOf and
/// replayTakes.
Result<RunVolume> workpieceOf(const Project& project, const WorkpieceChoice& choice, CommandContext& context);

} // namespace burin
