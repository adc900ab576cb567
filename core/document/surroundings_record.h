// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/program_target.h"
#include "core/machine/envelope.h"
#include "core/setup/axis_mode.h"
#include "core/setup/guide.h"
#include "core/setup/obstacle.h"

#include <optional>
#include <string>
#include <string_view>

namespace burin {

// The fixtures, limits and guides of a project as JSON text: keys with their units, every number bit for bit. Numbers
// are finite. Reading returns nothing for text that these functions never write, or for values that can't be used.

/// Large data, a mesh or a curve, is packed in the blob, which is empty if there is none.
struct RecordWithBlob {
    std::string json;
    std::string blob;
};

/// A box or cylinder is stored in the JSON, a mesh in the blob. Of a fixture of the library, the JSON also states kind,
/// sizes and position.
RecordWithBlob recordOf(const Obstacle& obstacle);
std::optional<Obstacle> obstacleFrom(std::string_view json, std::string_view blob);

/// A guide without its curve, which is stored in the blob.
RecordWithBlob recordOf(const Guide& guide);
/// The guide's curve is null; `curve` receives it if the guide has one.
std::optional<Guide> guideFrom(std::string_view json, std::string_view blob, std::optional<GuideCurve>& curve);

std::string toJson(const AxisMode& axis);
std::optional<AxisMode> axisModeFromJson(std::string_view text);

std::string toJson(const TravelPlacement& placement);
std::optional<TravelPlacement> travelPlacementFromJson(std::string_view text);

std::string toJson(const ProgramTarget& target);
std::optional<ProgramTarget> programTargetFromJson(std::string_view text);
std::string programDraftToJson(const std::string& text);
std::optional<std::string> programDraftFromJson(std::string_view text);

} // namespace burin
