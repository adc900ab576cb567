// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/verify/tool_moves.h"
#include "core/verify/verify.h"
#include "core/volume/runs/run_volume.h"

#include <span>
#include <vector>

namespace burin {

/// Largest number of program lines whose touched voxels are reported: those with the largest overlaps.
inline constexpr std::size_t mostTouched = 10;

/// Finds where shank and holder touch the workpiece on the lines of `found` that report it: the collision area (paper,
/// eq. 4) at the pose of the line with the largest overlap, searched at every voxel of the path, after everything
/// before it was cut.
/// @param workpiece as it is before the moves; its state afterwards is unspecified
/// Errors: volumeOutOfMemory, cancelled.
Result<std::vector<TouchedVoxels>> findTouchedVoxels(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                                                     RunVolume& workpiece, const std::vector<Finding>& found,
                                                     Progress& progress);
bool isShankOrHolder(const Finding& finding) noexcept;

} // namespace burin
