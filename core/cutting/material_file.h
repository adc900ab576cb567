// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/property_list.h"

#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// A material as a file has it, and what the file did not say or Burin can't hold.
struct ReadMaterial {
    Property material;
    std::string format;             ///< "Burin", "FreeCAD"
    std::vector<std::string> notes; ///< English, a sentence each
};

/// Reads a material: Burin's own JSON, or a FreeCAD card (.FCMat) in its form of YAML (version 1.0) or of sections (up
/// to 0.20). The kind is found from the content. Of a card: surface speeds, the unit cutting force with its exponent
/// (Kienzle), Kp, density and hardness, in any of the units that FreeCAD writes; what it lacks and milling needs is
/// filled with an estimate and told.
/// @param id of the material; empty: made of the name in the file, or what Burin's own form states
/// @param origin file name for messages
/// Errors: fileFormatUnknown, resourceInvalid (place: the line or the key), those of checkMaterial.
Result<ReadMaterial> materialFromText(std::string_view text, const std::string& origin, const std::string& id = {});

} // namespace burin
