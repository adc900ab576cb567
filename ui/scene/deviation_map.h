// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/verify/verify.h"

#include <filesystem>

namespace burin {

/// Writes deviations as a VTK PolyData file (.vtp): a point each, with arrays `excess_mm` and `reachable`.
/// Errors: fileNotWritable, diskFull.
Result<void> writeDeviationMap(const std::vector<DeviationSample>& deviations, const std::filesystem::path& file);

} // namespace burin
