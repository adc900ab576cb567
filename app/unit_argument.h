// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command_line.h"
#include "core/base/result.h"
#include "core/cad/import.h"

#include <string>

namespace burin {

/// Declares --unit.
void addUnit(CommandParser command, std::string& unit);
/// Sets the unit that the argument requests; "stated" sets none, and empty leaves the options unchanged. Errors:
/// argumentInvalid.
Result<void> applyUnit(const std::string& unit, ImportOptions& options);

} // namespace burin
