// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/machine/machine_profile.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Loads a machine that is shipped with Burin or that the user added: machines/<id>.json. Errors: nameUnknown,
/// resourceInvalid.
Result<MachineProfile> loadMachine(std::string_view id);
/// Ids of all available machines, sorted.
std::vector<std::string> machineIds();
/// @param origin file name for messages. Errors: resourceInvalid.
Result<MachineProfile> machineFromJson(std::string_view text, const std::string& origin);
/// The file of a machine: with every key that the profile states. `machineFromJson` reads the same profile from it.
std::string toJson(const MachineProfile& machine);

/// The same machine under another id and name; its source names the machine it was copied from.
MachineProfile copyOf(const MachineProfile& machine, const std::string& id, const std::string& name);

/// Whether the machine in force with this id is shipped with Burin: its values are typical of a class of machines, and
/// it can be copied, but neither changed nor deleted.
bool isTypicalMachine(std::string_view id);

/// Checks `machine` like a machine file and adds it to the user's own machines.
/// @param replace whether to replace a machine of the user that has this id already
/// @return its file. Errors: resourceInvalid, argumentInvalid (the id of a shipped machine, or without `replace` of one
/// of the user's; an id that can't be a file name), fileNotWritable, diskFull.
Result<std::filesystem::path> saveMachine(const MachineProfile& machine, bool replace);
/// Deletes one of the user's own machines. Errors: argumentInvalid (a shipped one), nameUnknown, fileNotWritable.
Result<void> removeMachine(const std::string& id);

} // namespace burin
