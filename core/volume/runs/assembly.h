// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/brick_lines.h"
#include "core/volume/runs/run_volume.h"

#include <functional>
#include <vector>

namespace burin {

/// Makes a volume line by line.
/// @param describe appends the segments of a line, from 0 to the line's end; called on several threads at once, and
///        again when more memory turns out to be needed
/// Errors: outOfMemory.
Result<RunVolume> assemble(const Grid& grid, PropertyList properties,
                           const std::function<void(LineIndex, std::vector<Segment>&)>& describe);

/// Makes a volume brick by brick, the fastest method. Bricks that are not handed over are air.
/// @param describe as for RunVolume::rewriteBricks; called again when more memory turns out to be needed
/// @param reservedBytes  initial reserve, as for RunVolume::make. The volume has at least as much memory left for edits
///        as its runs take.
/// Errors: outOfMemory.
Result<RunVolume> assembleBricks(const Grid& grid, const PropertyList& properties,
                                 const std::function<void(std::int32_t row, BrickSink& sink)>& describe,
                                 std::size_t reservedBytes = 0);

} // namespace burin
