// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/base/text.h"
#include "core/geometry/plan_region.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// What a computed pass does.
enum class PassKind : std::uint8_t {
    levels,    ///< takes away what stands, level by level, along the part
    pocket,    ///< the same within an area that the cutter does not leave
    profile,   ///< once along an area's border, or the part's outline, level by level
    face,      ///< takes away what stands above the part
    parallel,  ///< parallel rows on the part
    radial,    ///< rows from a centre outwards on the part
    spiral,    ///< one row round a centre on the part
    flow,      ///< rows on the part that follow lines, blended between them
    waterline, ///< along the part at one height after the other
    scallop,   ///< rows on the part that are evenly far apart on it
    pencil,    ///< along concave edges of the part
    rest,      ///< rows and contours where stock is left
    engrave,   ///< along lines, at a depth
    drill,     ///< straight down in round holes of the part, or at places
};

/// What a request without them means, of the tool's diameter.
inline constexpr double usualRoughStep = 0.4, usualFineStep = 1.0 / 15.0, usualStairs = 0.1;

/// One kind, as users name and read it.
struct PassKindRow {
    PassKind kind = PassKind::levels;
    std::string_view id; ///< "levels", stable
    TextId title, toolTip;
};
/// All kinds, in the order of the enumeration.
extern const std::array<PassKindRow, 14> passKinds;
const PassKindRow& rowOf(PassKind kind) noexcept;
/// Errors: nameUnknown (detail: those that there are).
Result<PassKind> passKindWithId(std::string_view id);

/// A line that leads a pass or is engraved, mm, setup frame.
using PassLine = std::vector<glm::dvec3>;

/// How much deeper than the bottom of a hole a drill goes with its full diameter, mm; the part holds it up before.
inline constexpr double drilledThrough = 0.2;

/// Of PassRequest::tabs.
inline constexpr int mostTabs = 100;

/// Of PassRequest::steepest, more than a right angle: no limit.
inline constexpr double anySlope = 1.6; // rad

/// What a planner is asked for. Lengths in mm, angles in rad, setup frame; upright tools.
struct PassRequest {
    PassKind kind = PassKind::levels;
    double allowance = 0.0; ///< left on the part
    double stepOver = 0.0; ///< between rows or loops, between heights of `waterline`; 0: by scallop, or the kind's rule
    double scallop = 0.0;  ///< height of the ridges between rows of a tool with a rounded end; 0: not asked for
    double levelDepth = 0.0;    ///< between levels; 0: what tool, spindle and material bear; of `drill` of one peck
    double stairs = 0.0;        ///< of `levels`: what they leave on slopes, at most; 0: a tenth of the diameter
    double direction = 0.0;     ///< of parallel rows, anticlockwise from X
    double flattest = 0.0;      ///< slope of the part, from level: rows and waterlines stay where it is no less …
    double steepest = anySlope; ///< … and no more
    std::optional<double> top,
        bottom;              ///< heights of the first stock and of the lowest tip; none: the stock's, the part's
    bool oneWay = false;     ///< rows all in one direction
    bool inside = false;     ///< of `profile`: within the area's border instead of around it
    bool restOnly = false;   ///< rows only where stock is left
    bool areaOnPart = false; ///< of rows and waterlines: the area is of what the tool touches, not of its tip
    PlanRegion area;         ///< where the tip may be; of pocket and profile: what the cutter makes. Empty: everywhere
    std::vector<PassLine> lines;
    double depth = 0.0;               ///< of `engrave` and `drill`, below the top; `drill`: 0 by the part's hole
    std::vector<glm::dvec2> places{}; ///< of `drill`; none: every hole of the part that fits the drill
    int tabs = 0;                     ///< of `profile`: bridges that are left round each outline
    double tabWidth = 0.0;            ///< of each, along the outline
    double tabHeight = 0.0;           ///< of each, above the lowest level
    bool dogbones = false; ///< of `pocket` and `profile`: into inner corners of the area, as far as the cutter's edge

    bool limitsSlope() const noexcept { return flattest > 0.0 || steepest < anySlope; }
    /// Whether the part is as steep as is asked for. @param away unit, the way out of the part where the tool touches
    /// it
    bool allowsSlope(const glm::dvec3& away) const noexcept;

    friend bool operator==(const PassRequest&, const PassRequest&) = default;
};

/// Errors: argumentInvalid (subject: the key of its JSON, place: the value, detail: what is allowed).
Result<void> validate(const PassRequest& request);

/// {"pass": id, keys with their unit}; what has its first value is left out.
std::string toJson(const PassRequest& request);
/// Errors: resourceInvalid, nameUnknown, those of `validate`. @param origin for messages
Result<PassRequest> passRequestFromJson(std::string_view text, const std::string& origin);

} // namespace burin
