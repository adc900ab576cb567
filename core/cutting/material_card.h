// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace burin {

/// What a FreeCAD material card says, whichever section or model it stands in.
struct MaterialCard {
    std::map<std::string, std::string, std::less<>> values;
};

/// Reads a card in its form of YAML or of sections. Bounded: cards longer than 1 MB, or nested deeper than a card is,
/// are refused. Errors: fileFormatUnknown (neither), resourceInvalid (place: the line).
Result<MaterialCard> readMaterialCard(std::string_view text, const std::string& origin);

} // namespace burin
