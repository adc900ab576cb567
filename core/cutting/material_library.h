// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/property_list.h"

#include <filesystem>
#include <string>

namespace burin {

/// Checks that a material can be milled by its values: all values that Burin reads have the expected units and are
/// above 0 (Kienzle's exponent from 0 to below 1), and there is a specific cutting energy or a Kienzle force.
/// Errors: resourceInvalid (subject: `origin`, place: the value).
Result<void> checkMaterial(const Property& material, const std::string& origin);

/// Returns the same material with another id and name; each source states what it was copied from.
Property copyOf(const Property& material, const std::string& id, const std::string& name);

/// Whether the material that is used for this id is the one shipped with Burin.
bool isShippedMaterial(std::string_view id);

/// Checks a material and adds it to the user's own materials, where it takes precedence over a shipped one of the same
/// id. @param replace an existing one of this id, shipped or the user's own
/// @return its file. Errors: those of checkMaterial, argumentInvalid (an id that is in use or invalid),
/// fileNotWritable, diskFull.
Result<std::filesystem::path> saveMaterial(const Property& material, bool replace);
/// Deletes one of the user's own materials. Errors: argumentInvalid (a shipped one), nameUnknown, fileNotWritable.
Result<void> removeMaterial(const std::string& id);

} // namespace burin
