// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/machine/machine_profile.h"

#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Machines that Burin is shipped with or the user added: machines/<id>.json. Errors: nameUnknown, resourceInvalid.
Result<MachineProfile> loadMachine(std::string_view id);
/// Ids of all machines there are, sorted.
std::vector<std::string> machineIds();
/// @param origin file name for messages. Errors: resourceInvalid.
Result<MachineProfile> machineFromJson(std::string_view text, const std::string& origin);

} // namespace burin
