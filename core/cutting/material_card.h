// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace burin {

/// The values of a FreeCAD material card, regardless of the section or model that states them.
struct MaterialCard {
    std::map<std::string, std::string, std::less<>> values;
};

/// Reads a card in YAML form or in the form with sections. The size is limited: cards longer than 1 MB, or nested
/// deeper than real cards, are rejected. Errors: fileFormatUnknown (neither form), resourceInvalid (place: the line).
Result<MaterialCard> readMaterialCard(std::string_view text, const std::string& origin);

} // namespace burin
