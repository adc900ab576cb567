// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/geometry/revolved_piece.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// The form of the flutes. All are solids of revolution about the tool axis, the tip at height 0.
enum class CutterType : std::uint8_t {
    ball,      ///< hemisphere, then a cylinder
    flat,      ///< cylinder
    bullNose,  ///< cylinder with a rounded edge
    taper,     ///< cone that widens from a flat, perhaps rounded, tip to the diameter, then a cylinder
    taperBall, ///< ball that goes over smoothly into a cone, then a cylinder
    drill,     ///< cone from a point to the diameter, then a cylinder
    chamfer,   ///< cone from a point or a flat tip to the diameter, then a cylinder
    lollipop,  ///< sphere, cut off where the shank begins
    profile,   ///< any lines and arcs
};
/// "ball", "flat", "bull_nose" … as files and reports have it.
std::string_view cutterTypeName(CutterType type) noexcept;

/// One line or arc of a profile, from where the one before it ended (the first: from the tip, radius 0, height 0). The
/// tool lies between the profile and its axis, so heights never fall (`validate`): a level line is a face or a
/// shoulder, and a tip that is cupped can't be drawn, but has to be taken as flat, which is never smaller. Hollow arcs
/// are taken as chords (`profileChord`).
struct ProfileElement {
    double radius = 0.0;    ///< mm from the axis, of its end
    double height = 0.0;    ///< mm above the tip, of its end
    double arcRadius = 0.0; ///< mm; 0: a straight line. The shorter of the two arcs; it has to rise all the way.
    bool hollow = false;    ///< the arc curves towards the axis (concave) instead of away from it
};

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
    double diameter = 0.0;      ///< of the flutes where they are widest, mm
    double cornerRadius = 0.0;  ///< mm: of a ball, or of the rounding of an edge; 0: sharp
    double fluteLength = 0.0;   ///< mm from the tip
    double shankDiameter = 0.0; ///< mm
    double stickOut = 0.0;      ///< mm from the tip to the face of the holder
    std::vector<HolderSegment> holder;
    double tipDiameter = 0.0; ///< mm: taper and chamfer, of the flat tip, measured at its edge before that is rounded
    double taperAngle = 0.0;  ///< rad, between axis and cone: taper, taper ball, drill, chamfer (half of a point angle)
    std::vector<ProfileElement> profile{}; ///< of CutterType::profile

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
    std::string source;               ///< where the dimensions come from, unless `sources` says otherwise
    Cutter cutter;
    // What it bears; 0: not stated, and not judged.
    double modulus = 0.0;                         ///< N/mm², of elasticity, of what shank and flutes are made of
    double strength = 0.0;                        ///< N/mm², at which it breaks when it is bent
    double maximumChipLoad = 0.0;                 ///< mm a tooth, greatest thickness of its chip
    double maximumWidthOfCut = 0.0;               ///< radial, mm
    std::map<std::string, std::string> sources{}; ///< by key of the file: where that value comes from

    /// Whether the value of a key is somebody's estimate, by what its source says. Thread-safe.
    bool isEstimate(const std::string& key) const;
};

/// Errors: argumentInvalid with the key and what is allowed (diameters > 0, 0 <= corner radius <= radius, flutes at
/// least as long as the corner is high, stick-out >= flutes, no empty holder segment; what a type does not use is 0).
Result<void> validate(const Tool& tool);

/// The flutes as convex pieces from the tip up: one for ball, flat, bull nose and lollipop, more for the rest. Exact,
/// except that hollow arcs are chords: they stand away from the axis by at most `profileChord`, so that the tool is
/// never smaller than it is in truth; what is found clear of the part is clear.
/// @param cutter of a valid tool
std::vector<RevolvedPiece> flutePieces(const Cutter& cutter);
inline constexpr double profileChord = 0.0005; ///< mm
/// The flutes of a cutter that has one piece of them (asserted).
RevolvedPiece flutes(const Cutter& cutter);
/// `flutePieces`, then the shank (none where the flutes reach the holder), then the holder from below, for geometry
/// that knows no tools.
std::vector<RevolvedPiece> pieces(const Cutter& cutter);

/// How much a drill may enter the part at the wall of its own hole, mm: facets lie inside the hole by the mesh's chord.
inline constexpr double drillFit = 0.012;

enum class ToolSection : std::uint8_t { flutes, shank, holder };
/// Where a place in `pieces` belongs.
ToolSection sectionOf(const Cutter& cutter, std::size_t piece);

/// Tools that Burin is shipped with or the user added: tools/<id>.json. Errors: nameUnknown, resourceInvalid.
Result<Tool> loadTool(std::string_view id);
/// Ids of all tools there are, sorted.
std::vector<std::string> toolIds();
/// A tool as JSON text and back; the form of resources/tools and of the project file.
std::string toJson(const Tool& tool);
/// @param origin file name for messages. Errors: resourceInvalid.
Result<Tool> toolFromJson(std::string_view text, const std::string& origin);

} // namespace burin
