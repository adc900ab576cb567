// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/error.h"
#include "core/volume/runs/run_volume.h"

#include <string>

namespace burin {

class CommandContext;

/// readAnyVolume, as a stage of a command. Reports a file that states no unit.
Result<RunVolume> readVolume(const std::string& file, const std::string& table, CommandContext& context);

/// A read error with "table" replaced by the option's name.
Error withTableOption(Error error, const char* option);

/// Reports that a voxel array states no unit of length.
void tellUnknownUnit(const std::string& file, CommandContext& context);

} // namespace burin
