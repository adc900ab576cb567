// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/machine/machine_profile.h"

#include <string>

namespace burin {

/// Returns the error of a value beyond a limit of the machine. @param unit of the value
Error limitError(const std::string& what, double value, const std::string& limit, const char* unit);

/// Errors: programLimit. @param speed 1/min
Result<void> checkSpindleSpeed(double speed, const MachineProfile& machine);

/// Errors: notSupported (the machine lacks it).
Result<void> checkCoolant(Coolant coolant, const MachineProfile& machine);

} // namespace burin
