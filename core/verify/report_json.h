// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/verify.h"

#include <string>

namespace burin {

/// A report as one JSON object without its deviations; keys carry their unit. What commands print and projects keep
/// beside a program.
std::string toJson(const VerifyReport& report);

} // namespace burin
