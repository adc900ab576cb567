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

// What a project keeps of what bounds and leads its tool, as JSON text: keys with their units, every number bit for
// bit. Numbers are finite. Reading gives nothing for what these functions never write, or for values that can't be
// used.

/// What is large stands beside it, packed: a mesh, a curve. Empty where there is none.
struct RecordWithBlob {
    std::string json;
    std::string blob;
};

/// A box or cylinder stands in the JSON, a mesh in the blob.
RecordWithBlob recordOf(const Obstacle& obstacle);
std::optional<Obstacle> obstacleFrom(std::string_view json, std::string_view blob);

/// A guide without its curve, which is in the blob.
RecordWithBlob recordOf(const Guide& guide);
/// A guide's curve is null; `curve` gets it where the guide has one.
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
