// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/findings.h"
#include "core/verify/tool_moves.h"

namespace burin {

/// Cuts the moves into a workpiece, flutes before shank and holder, in steps of at most a voxel, and reports what must
/// not happen: removal by a rapid or with the spindle off, shank or holder in anything.
/// @return mm³ removed. Errors: volumeOutOfMemory, cancelled.
Result<double> replay(const std::vector<ToolMove>& moves, const Tool& tool, RunVolume& workpiece, Findings& findings,
                      Progress& progress);

} // namespace burin
