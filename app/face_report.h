// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/face_quality.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace burin {

/// [{"face", "kind", "diameter_mm", "area_mm2", "samples", "gouge_max_mm", "gouge_place_mm", "excess_max_mm",
/// "excess_place_mm", "in_tolerance", "gouge", "excess", "unreachable"}], setup frame; null: not known, or there is
/// none
nlohmann::json jsonOf(const std::vector<FaceQuality>& faces);
/// A line for each face, for people; lines that follow others.
std::string textOf(const std::vector<FaceQuality>& faces);

} // namespace burin
