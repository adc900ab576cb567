// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/json_object.h"
#include "core/tool/cutting_preset.h"

#include <nlohmann/json_fwd.hpp>

namespace burin {

/// Reads the list "presets" of a tool's file; an error makes `file` fail.
void readPresets(JsonObject& file, std::vector<CuttingPreset>& presets);
/// Returns that list; values that are not stated are left out.
nlohmann::ordered_json presetsJson(const std::vector<CuttingPreset>& presets);

} // namespace burin
