// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/coolant.h"
#include "core/tool/tool.h"
#include "core/volume/runs/property_list.h"

namespace burin {

// Named values of a material: 1 if the coolant is advised, 0 or missing if not.
inline constexpr std::string_view floodCoolant = "flood_coolant";
inline constexpr std::string_view mistCoolant = "mist_coolant";

/// Returns the coolant of the tool's preset for a material; if it states none, that advised for the material: flood
/// takes precedence over mist; none if neither is advised.
Coolant advisedCoolant(const Tool& tool, const Property& material);

} // namespace burin
