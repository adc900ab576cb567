// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/machine/machine_profile.h"

#include <string_view>
#include <vector>

namespace burin {

/// Errors: nameUnknown, resourceInvalid.
Result<MachineProfile> loadMachine(std::string_view id);
std::vector<std::string> machineIds();

} // namespace burin
