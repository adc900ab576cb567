// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/run_volume.h"

#include <functional>
#include <vector>

namespace burin {

/// Makes a volume line by line.
/// @param describe appends the segments of a line, from 0 to the line's end; called on several threads at once
/// Errors: outOfMemory, volumeOutOfMemory.
Result<RunVolume> assemble(const Grid& grid, PropertyList properties,
                           const std::function<void(LineIndex, std::vector<Segment>&)>& describe);

} // namespace burin
