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
    levels,    ///< removes the standing stock level by level along the part
    pocket,    ///< the same, within an area that the cutter does not leave
    profile,   ///< once along the border of an area, or the outline of the part, level by level
    face,      ///< removes the stock above the part
    parallel,  ///< parallel rows on the part
    radial,    ///< rows on the part from a centre outwards
    spiral,    ///< one row around a centre on the part
    flow,      ///< rows on the part that follow lines, blended between them
    waterline, ///< contours of the part at one height after the other
    scallop,   ///< rows on the part at even distances, measured on the part
    pencil,    ///< along concave edges of the part
    rest,      ///< rows and contours where stock is left
    engrave,   ///< along lines, at a depth
    drill,     ///< straight down in round holes of the part, or at given points
    thread,    ///< threads, milled in round holes of the part or on its studs
};

/// Defaults of a request that does not state these values, relative to the diameter of the tool.
inline constexpr double usualRoughStep = 0.4, usualFineStep = 1.0 / 15.0, usualStairs = 0.1;

/// A pass kind with the texts that users see.
struct PassKindRow {
    PassKind kind = PassKind::levels;
    std::string_view id; ///< "levels", stable
    TextId title, toolTip;
};
/// All kinds, in the order of the enumeration.
extern const std::array<PassKindRow, 15> passKinds;
const PassKindRow& rowOf(PassKind kind) noexcept;
/// Whether a kind works in round holes, or on round studs: its request may name them.
bool isInHoles(PassKind kind) noexcept;
/// Errors: nameUnknown (detail: the known ids).
Result<PassKind> passKindWithId(std::string_view id);

/// A line that guides a pass or is engraved, mm, setup frame.
using PassLine = std::vector<glm::dvec3>;

/// What a pass does in round holes or on round studs, as texts distinguish it.
enum class HoleWork : std::uint8_t { drilling, internalThreads, externalThreads };

/// How far a drill goes below the bottom of a hole with its full diameter, mm; less where the part stops it.
inline constexpr double drilledThrough = 0.2;

/// Upper limit of PassRequest::tabs.
inline constexpr int mostTabs = 100;
/// Upper limit of PassRequest::radialPasses.
inline constexpr int mostRadialPasses = 20;

/// Value of PassRequest::steepest that means no limit; more than a right angle.
inline constexpr double anySlope = 1.6; // rad

/// What a pass does where strokes of the hand, earlier in the same path, have finished the part.
enum class HandStrokes : std::uint8_t {
    ignore,  ///< mills there like anywhere else
    keepOff, ///< stays so far away that it cuts nothing of what they finished
    blend,   ///< goes on over the border for an overlap, and rises there to the height that the hand left
    extend,  ///< of `flow`: its rows continue those strokes sideways, step by step, up to the border of the area
};
/// Their ids, "ignore" and so on, in the order of the enumeration.
extern const std::array<std::string_view, 4> handStrokesIds;
/// Whether a kind of pass may do anything but ignore them.
bool heedsHandStrokes(PassKind kind) noexcept;
/// Defaults of PassRequest::overlap and PassRequest::finishedWithin, mm.
inline constexpr double usualOverlap = 0.5, usualFinish = 0.02;

/// A take whose strokes lead a pass.
struct PassLead {
    std::int64_t take = 0;
    int lines = 0; ///< how many of the request's lines came from it
    friend bool operator==(const PassLead&, const PassLead&) = default;
};

/// The request to a planner. Lengths in mm, angles in rad, setup frame; upright tools.
struct PassRequest {
    PassKind kind = PassKind::levels;
    double allowance = 0.0; ///< stock left on the part
    /// between rows or loops; of `waterline` between heights; 0: by scallop, or the default of the kind
    double stepOver = 0.0;
    double scallop = 0.0; ///< height of the ridges between rows of a tool with a rounded end; 0: not requested
    /// between levels; 0: by preset, else what tool, spindle and material can bear; of `drill`: of one peck
    double levelDepth = 0.0;
    double stairs = 0.0;        ///< of `levels`: largest height of the steps left on slopes; 0: a tenth of the diameter
    double direction = 0.0;     ///< of parallel rows, anticlockwise from X
    double flattest = 0.0;      ///< smallest slope of the part from level at which rows and waterlines are kept …
    double steepest = anySlope; ///< … and the largest
    std::optional<double> top,
        bottom;              ///< heights of the first stock and of the lowest tip; none: the stock's, the part's
    bool oneWay = false;     ///< rows all in one direction
    bool inside = false;     ///< of `profile`: inside the border of the area instead of around it
    bool restOnly = false;   ///< only rows where stock is left
    bool areaOnPart = false; ///< of rows and waterlines: the area limits the contact points of the tool, not its tip
    PlanRegion area;         ///< where the tip may be; of pocket and profile: the shape to cut. Empty: everywhere
    std::vector<PassLine> lines;
    std::vector<PassLead> leads{}; ///< where the first of the lines come from, in their order
    HandStrokes hand = HandStrokes::ignore;
    double overlap = 0.0; ///< of `HandStrokes::blend`, along a row; 0: usualOverlap
    /// Unless strokes are ignored: the height that they may leave above this pass on what counts as finished; 0:
    /// usualFinish
    double finishedWithin = 0.0;
    /// Identifies the strokes of the hand that the pass was computed on (digestOf); empty: they were ignored
    std::string strokesDigest{};
    /// of `engrave` and `drill`, below the top; of `thread`, below the top of its hole or stud; `drill`, `thread`: 0:
    /// from the hole or stud of the part
    double depth = 0.0;
    /// of `drill` and `thread`, each in a hole or stud; empty: every one that fits the drill or the thread
    std::vector<glm::dvec2> places{};
    int tabs = 0;           ///< of `profile`: number of tabs left along each outline
    double tabWidth = 0.0;  ///< of each tab, along the outline
    double tabHeight = 0.0; ///< of each tab, above the lowest level
    /// of `pocket` and `profile`: reach into inner corners of the area with the edge of the cutter
    bool dogbones = false;
    // Of `thread`:
    double pitch = 0.0;         ///< mm between neighbouring crests
    double majorDiameter = 0.0; ///< of the thread; 0: as the holes or studs at `places` have it
    int radialPasses = 1;       ///< how often the tool follows the thread, deeper each time
    bool external = false;      ///< on studs instead of in holes
    bool leftHand = false;      ///< instead of right-handed
    bool conventional = false;  ///< against the feed instead of climb milling
    bool springPass = false;    ///< follows the thread once more at full depth

    bool limitsSlope() const noexcept { return flattest > 0.0 || steepest < anySlope; }
    /// Whether the slope of the part is within the requested range. @param away unit vector that points out of the part
    /// at the contact point of the tool
    bool allowsSlope(const glm::dvec3& away) const noexcept;

    friend bool operator==(const PassRequest&, const PassRequest&) = default;
};

/// Of a kind that works in holes.
HoleWork holeWorkOf(const PassRequest& request) noexcept;

/// Errors: argumentInvalid (subject: the key of its JSON, place: the value, detail: what is allowed).
Result<void> validate(const PassRequest& request);

/// {"pass": id, keys with their unit}; values equal to their default are omitted.
std::string toJson(const PassRequest& request);
/// Errors: resourceInvalid, nameUnknown, those of `validate`. @param origin for messages
Result<PassRequest> passRequestFromJson(std::string_view text, const std::string& origin);

} // namespace burin
