// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/verify.h"

#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// A report as one JSON object without its deviations; keys carry their unit. What commands print and projects keep
/// beside a program.
std::string toJson(const VerifyReport& report);

/// What `toJson` wrote of the verdict: figures, findings, near passes and touched voxels. Times, loads and deviations
/// are not in it. Nothing: it wrote no such text.
std::optional<VerifyReport> reportFromJson(std::string_view text);

/// The load of a program as JSON: "load_by_block", an entry for each block that removes something, with its mean and
/// its peak; and "load_over_time", the greatest force and power in equal intervals. Not part of a stored report.
std::string loadsToJson(const VerifyReport& report);

} // namespace burin
