// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/coolant.h"
#include "core/base/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

struct Tool;

/// Feeds and speeds of a tool in one material. They replace those that the tables give for tool and material.
struct CuttingPreset {
    std::string name;          ///< one line; no other preset of the tool has it
    std::string material;      ///< id; empty: any material
    double spindleSpeed = 0.0; ///< 1/min
    double feed = 0.0;         ///< mm/min; 0: stated by chipLoad
    double chipLoad = 0.0;     ///< mm per tooth; 0: stated by feed
    double plungeFeed = 0.0;   ///< mm/min; 0: not stated
    double stepDown = 0.0;     ///< mm, depth of a level; 0: not stated
    double stepOver = 0.0;     ///< mm, distance between loops of a level; 0: not stated
    std::optional<Coolant> coolant{};

    friend bool operator==(const CuttingPreset&, const CuttingPreset&) = default;
};

/// Returns the feed of a preset at its spindle speed, mm/min.
double feedOf(const CuttingPreset& preset, int fluteCount) noexcept;

/// Returns the first preset for the material; without one, the first for the material that it is a grade of; without
/// one, the first for any material; nullptr if the tool has none of these.
/// @param material id @param base id; empty: the material is no grade
const CuttingPreset* presetFor(const Tool& tool, std::string_view material, std::string_view base) noexcept;

/// Errors: argumentInvalid with the key of the tool's file, the value and what is allowed.
Result<void> validatePresets(const Tool& tool);

/// Returns the name, with a number appended if one of the presets has it already.
std::string freePresetName(const std::vector<CuttingPreset>& presets, const std::string& name);

} // namespace burin
