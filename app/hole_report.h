// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/upright_holes.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace burin {

/// [{"centre_mm": [x, y], "diameter_mm", "top_mm", "bottom_mm"}], setup frame
nlohmann::json jsonOf(const std::vector<UprightHole>& holes);
/// The number of holes of each diameter, as readable text: one line; empty if there are none.
std::string textOf(const std::vector<UprightHole>& holes);
/// The same of studs.
std::string textOfStuds(const std::vector<UprightHole>& studs);

} // namespace burin
