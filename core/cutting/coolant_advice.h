// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/coolant.h"
#include "core/volume/runs/property_list.h"

namespace burin {

// Named values of a material: 1 where it is advised, 0 or missing where not.
inline constexpr std::string_view floodCoolant = "flood_coolant";
inline constexpr std::string_view mistCoolant = "mist_coolant";

/// What a material is best cut under: flood before mist, none where it advises neither.
Coolant advisedCoolant(const Property& material);

} // namespace burin
