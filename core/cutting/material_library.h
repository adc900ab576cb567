// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/property_list.h"

#include <filesystem>
#include <string>

namespace burin {

/// That a material can be milled by its values: those that Burin reads are in the units that it reads them in and above
/// 0 (Kienzle's exponent from 0 to below 1), and a specific cutting energy or a Kienzle force is among them.
/// Errors: resourceInvalid (subject: `origin`, place: the value).
Result<void> checkMaterial(const Property& material, const std::string& origin);

/// The same material under another id and name; each source says what it was copied from.
Property copyOf(const Property& material, const std::string& id, const std::string& name);

/// The material in force under this id is the one that Burin is shipped with.
bool isShippedMaterial(std::string_view id);

/// Checks a material and adds it to the user's own, where it stands before one of the same id that Burin is shipped
/// with. @param replace one of this id, whoever's it is
/// @return its file. Errors: those of checkMaterial, argumentInvalid (an id that is taken, or is none),
/// fileNotWritable, diskFull.
Result<std::filesystem::path> saveMaterial(const Property& material, bool replace);
/// Deletes one of the user's own. Errors: argumentInvalid (a shipped one), nameUnknown, fileNotWritable.
Result<void> removeMaterial(const std::string& id);

} // namespace burin
