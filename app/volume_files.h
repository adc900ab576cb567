// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <string>

namespace burin {

class CommandContext;

/// Reads a volume file, or a voxel array with the table of its materials; the kind is found from the content. A file
/// that states no unit is told. Errors: those of readVolumeFile (also its damage), readArrayFile, ArrayTable::parse,
/// volumeOf, argumentInvalid (an array without a table).
Result<RunVolume> readAnyVolume(const std::string& file, const std::string& table, CommandContext& context);

} // namespace burin
