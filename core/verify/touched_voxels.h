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

/// Lines of a program whose touched voxels are told: those with the largest overlaps.
inline constexpr std::size_t mostTouched = 10;

/// Where shank and holder touch the workpiece on the lines of `found` that say so: the collision area (paper, eq. 4) at
/// the pose of the line with the largest overlap, looked for once a voxel of the way, with all cut that is cut before.
/// @param workpiece as the moves find it; it is left anywhere
/// Errors: volumeOutOfMemory, cancelled.
Result<std::vector<TouchedVoxels>> findTouchedVoxels(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                                                     RunVolume& workpiece, const std::vector<Finding>& found,
                                                     Progress& progress);
bool isShankOrHolder(const Finding& finding) noexcept;

} // namespace burin
