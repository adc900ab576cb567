// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/geometry/revolved_piece.h"
#include "core/tool/cutting_preset.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

struct ToolSolid;

/// The shape of the flutes. All are solids of revolution about the tool axis, with the tip at height 0.
enum class CutterType : std::uint8_t {
    ball,      ///< hemisphere, then a cylinder
    flat,      ///< cylinder
    bullNose,  ///< cylinder with a rounded edge
    taper,     ///< cone that widens from a flat, possibly rounded, tip to the diameter, then a cylinder
    taperBall, ///< ball with a smooth transition into a cone, then a cylinder
    drill,     ///< cone from a point to the diameter, then a cylinder
    chamfer,   ///< cone from a point or a flat tip to the diameter, then a cylinder
    lollipop,  ///< sphere, cut off where the shank begins
    profile,   ///< any lines and arcs
};
/// Returns the name used in files and reports: "ball", "flat", "bull_nose" …
std::string_view cutterTypeName(CutterType type) noexcept;

/// One line or arc of a profile, from the end of the previous one (the first: from the tip, radius 0, height 0). The
/// tool lies between the profile and its axis, so heights never decrease (`validate`): a horizontal line is a face or a
/// shoulder. A cupped tip is given as flat, which is never smaller, and kept by the section of `Cutter::solid`. Hollow
/// arcs are replaced by chords (`profileChord`).
struct ProfileElement {
    double radius = 0.0;    ///< mm from the axis, of its end
    double height = 0.0;    ///< mm above the tip, of its end
    double arcRadius = 0.0; ///< mm; 0: a straight line. The shorter of the two arcs; it has to rise throughout.
    bool hollow = false;    ///< the arc curves towards the axis (concave) instead of away from it
};

/// A frustum of a holder; segments are stacked upwards.
struct HolderSegment {
    double lowerDiameter = 0.0; ///< mm
    double upperDiameter = 0.0; ///< mm
    double length = 0.0;        ///< mm
};

/// The space about the axis in which flutes that turn may be hollow; outside of it they are as the profile says.
struct HollowSpace {
    double radius = 0.0; ///< mm
    double height = 0.0; ///< mm above the tip
};

/// The geometry of a tool; tip at the origin, axis +Z towards the holder. The flutes are the paper's effective cutting
/// part; any contact of shank or holder is an error.
struct Cutter {
    CutterType type = CutterType::ball;
    double diameter = 0.0;      ///< largest diameter of the flutes, mm
    double cornerRadius = 0.0;  ///< mm: of a ball, or of the rounding of an edge; 0: sharp
    double fluteLength = 0.0;   ///< mm from the tip
    double shankDiameter = 0.0; ///< mm
    double stickOut = 0.0;      ///< mm from the tip to the face of the holder
    std::vector<HolderSegment> holder;
    double tipDiameter = 0.0; ///< mm: taper and chamfer, of the flat tip, measured at its edge before rounding
    double taperAngle = 0.0;  ///< rad, between axis and cone: taper, taper ball, drill, chamfer (half of a point angle)
    std::vector<ProfileElement> profile{}; ///< of CutterType::profile
    /// Null: the tool turns and has the shape above. Otherwise it has this shape (tool_solid.h), because it doesn't
    /// turn or is hollow; the profile encloses what it sweeps in a turn. The stock is cut and touched by the solid;
    /// whatever keeps the tool out of the part, of fixtures and of travel uses the profile, which is never smaller.
    std::shared_ptr<const ToolSolid> solid{};

    bool turns() const noexcept;
    bool isHollow() const noexcept { return solid != nullptr && turns(); }
    HollowSpace hollow() const noexcept; ///< empty if the tool doesn't turn or is not hollow
    double radius() const noexcept { return 0.5 * diameter; }
    double length() const noexcept; ///< tip to the top of the holder, mm
};

/// A cutter in its holder, with its data for the control and the shop.
struct Tool {
    std::string id;   ///< "ball-6", stable
    std::string name; ///< English
    int number = 1;   ///< T word
    int fluteCount = 2;
    bool centreCutting = true;        ///< may plunge
    double maximumDepthOfCut = 0.0;   ///< axial, mm; never beyond the flutes
    double maximumSpindleSpeed = 0.0; ///< 1/min, stated by the manufacturer; 0: not stated
    std::string source;               ///< where the dimensions come from, unless `sources` says otherwise
    Cutter cutter;
    // Limits of the tool; 0: not stated, and not checked.
    double modulus = 0.0;                         ///< N/mm², of elasticity, of the material of shank and flutes
    double strength = 0.0;                        ///< N/mm², bending strength
    double maximumChipLoad = 0.0;                 ///< mm per tooth, largest chip thickness
    double maximumWidthOfCut = 0.0;               ///< radial, mm
    std::map<std::string, std::string> sources{}; ///< by key of the file: where that value comes from
    std::vector<CuttingPreset> presets{};         ///< feeds and speeds of the user's own, by material

    /// Whether the value of a key is an estimate according to its source. Thread-safe.
    bool isEstimate(const std::string& key) const;
};

/// Errors: argumentInvalid with the key and what is allowed (diameters > 0, 0 <= corner radius <= radius, flutes at
/// least as long as the height of the corner, stick-out >= flutes, no empty holder segment; values that a type does not
/// use are 0; a solid lies within the profile), those of validatePresets.
Result<void> validate(const Tool& tool);
/// Errors: notSupported (subject: `request`), if the tool doesn't turn.
Result<void> checkTurns(const Cutter& cutter, std::string_view request);
/// Errors: notSupported, if the tool is cut as a solid and has to stay upright: it doesn't turn, or is hollow.
Result<void> checkTilts(const Cutter& cutter);

/// Returns the flutes as convex pieces from the tip up: one for ball, flat, bull nose and lollipop, more for the other
/// types. Exact, except that hollow arcs are replaced by chords, which are farther from the axis by at most
/// `profileChord`, so that the tool is never smaller than the real one; anything found clear of the part is clear.
/// @param cutter of a valid tool
std::vector<RevolvedPiece> flutePieces(const Cutter& cutter);
inline constexpr double profileChord = 0.0005; ///< mm
/// Returns the flutes of a cutter whose flutes are one piece (asserted).
RevolvedPiece flutes(const Cutter& cutter);
/// Returns `flutePieces`, then the shank (none if the flutes reach the holder), then the holder from below, for
/// geometry code that does not depend on tools.
std::vector<RevolvedPiece> pieces(const Cutter& cutter);

/// How far a drill or a thread mill may enter the part at the wall of its own hole, mm: facets lie inside the hole by
/// the mesh's chord error.
inline constexpr double drillFit = 0.012;

enum class ToolSection : std::uint8_t { flutes, shank, holder };
/// Returns the section that an index in `pieces` belongs to.
ToolSection sectionOf(const Cutter& cutter, std::size_t piece);

/// Loads a tool that is shipped with Burin or was added by the user: tools/<id>.json. Errors: nameUnknown,
/// resourceInvalid.
Result<Tool> loadTool(std::string_view id);
/// Returns the ids of all tools, sorted.
std::vector<std::string> toolIds();
/// Converts a tool to JSON text and back; the form used in resources/tools and in the project file.
std::string toJson(const Tool& tool);
/// @param origin file name for messages. Errors: resourceInvalid.
Result<Tool> toolFromJson(std::string_view text, const std::string& origin);

} // namespace burin
