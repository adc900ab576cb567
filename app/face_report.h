// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/face_quality.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace burin {

/// [{"face", "kind", "diameter_mm", "area_mm2", "samples", "gouge_max_mm", "gouge_place_mm", "excess_max_mm",
/// "excess_place_mm", "in_tolerance", "gouge", "excess", "unreachable"}], setup frame; null: not known, or does
/// not exist
nlohmann::json jsonOf(const std::vector<FaceQuality>& faces);
/// Returns human-readable text with a line for each face, to be appended to other lines.
std::string textOf(const std::vector<FaceQuality>& faces);

} // namespace burin
