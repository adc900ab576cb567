// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/verify.h"

#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// A report as one JSON object without its deviations; keys carry their unit. Commands print it, and projects store it
/// with a program.
std::string toJson(const VerifyReport& report);

/// Reads back the verdict that `toJson` wrote: values, findings, near passes and touched voxels. Times, loads and
/// deviations are not included. Empty if `toJson` did not write this text.
std::optional<VerifyReport> reportFromJson(std::string_view text);

/// The load of a program as JSON: "load_by_block", an entry with mean and peak for each block that removes material,
/// and "load_over_time", the greatest force and power in equal intervals. Not part of a stored report.
std::string loadsToJson(const VerifyReport& report);

} // namespace burin
