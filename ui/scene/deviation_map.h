// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/verify/deviation_map.h"

#include <filesystem>

namespace burin {

/// Writes deviations as a VTK PolyData file (.vtp): one point per sample, with arrays `excess_mm`, `reachable`,
/// `deviation_mm` (gouges are negative) and `colour` (red, green, blue: that of the window's deviation map).
/// Errors: fileNotWritable, diskFull.
Result<void> writeDeviationMap(const std::vector<DeviationSample>& deviations, const DeviationTolerance& tolerance,
                               const std::filesystem::path& file);

} // namespace burin
