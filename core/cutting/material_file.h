// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/property_list.h"

#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// A material as in its file, and notes on what the file lacks or Burin can't store.
struct ReadMaterial {
    Property material;
    std::string format;             ///< "Burin", "FreeCAD"
    std::vector<std::string> notes; ///< English, a sentence each
};

/// Reads a material: Burin's own JSON, or a FreeCAD card (.FCMat) in YAML form (version 1.0) or in the form with
/// sections (up to 0.20). The format is detected from the content. Read from a card: surface speeds, the unit cutting
/// force with its exponent (Kienzle), Kp, density and hardness, in any of the units that FreeCAD writes; values that it
/// lacks and milling needs are estimated and noted.
/// @param id of the material; empty: derived from the name in the file, or as stated in Burin's own format
/// @param origin file name for messages
/// Errors: fileFormatUnknown, resourceInvalid (place: the line or the key), those of checkMaterial.
Result<ReadMaterial> materialFromText(std::string_view text, const std::string& origin, const std::string& id = {});

} // namespace burin
