// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/geometry/revolved_piece.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

enum class CutterType : std::uint8_t { ball, flat, bullNose };

/// Frustum of a holder, stacked upwards.
struct HolderSegment {
    double lowerDiameter = 0.0; ///< mm
    double upperDiameter = 0.0; ///< mm
    double length = 0.0;        ///< mm
};

/// Geometry of a tool; tip at the origin, axis +Z towards the holder. The flutes are the paper's effective cutting
/// part; touching anything with shank or holder is a fault.
struct Cutter {
    CutterType type = CutterType::ball;
    double diameter = 0.0;      ///< of the flutes, mm
    double cornerRadius = 0.0;  ///< mm: diameter / 2 for a ball, 0 for a flat end
    double fluteLength = 0.0;   ///< mm from the tip
    double shankDiameter = 0.0; ///< mm
    double stickOut = 0.0;      ///< mm from the tip to the face of the holder
    std::vector<HolderSegment> holder;

    double radius() const noexcept { return 0.5 * diameter; }
    double length() const noexcept; ///< tip to the top of the holder, mm
};

/// A cutter in its holder, with what the control and the shop know of it.
struct Tool {
    std::string id;   ///< "ball-6", stable
    std::string name; ///< English
    int number = 1;   ///< T word
    int fluteCount = 2;
    bool centreCutting = true;        ///< may plunge
    double maximumDepthOfCut = 0.0;   ///< axial, mm; never beyond the flutes
    double maximumSpindleSpeed = 0.0; ///< 1/min, the tool maker's; 0: not stated
    std::string source;               ///< where the dimensions come from
    Cutter cutter;
};

/// Errors: argumentInvalid with the key and what is allowed (diameters > 0, 0 <= corner radius <= radius, flutes at
/// least as long as the corner is high, stick-out >= flutes, no empty holder segment).
Result<void> validate(const Tool& tool);

/// Flutes first, then the shank (none where the flutes reach the holder), then the holder from below, for geometry
/// that knows no tools.
std::vector<RevolvedPiece> pieces(const Cutter& cutter);
RevolvedPiece flutes(const Cutter& cutter);

/// Tools that Burin is shipped with or the user added: tools/<id>.json. Errors: nameUnknown, resourceInvalid.
Result<Tool> loadTool(std::string_view id);
/// Ids of all tools there are, sorted.
std::vector<std::string> toolIds();
/// A tool as JSON text and back; the form of resources/tools and of the project file.
std::string toJson(const Tool& tool);
/// @param origin file name for messages. Errors: resourceInvalid.
Result<Tool> toolFromJson(std::string_view text, const std::string& origin);

} // namespace burin
