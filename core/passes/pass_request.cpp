// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/pass_request.h"

#include "core/base/numbers.h"
#include "core/recording/generated_moves.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

const std::array<PassKindRow, 15> passKinds{{
    {PassKind::levels, "levels", BURIN_TEXT("Pass", "Levels"),
     BURIN_TEXT("Pass", "Roughing: clears the stock level by level, in loops along the part")},
    {PassKind::pocket, "pocket", BURIN_TEXT("Pass", "Pocket"),
     BURIN_TEXT("Pass", "Clears an area level by level; the cutter stays inside it")},
    {PassKind::profile, "profile", BURIN_TEXT("Pass", "Profile"),
     BURIN_TEXT("Pass", "Follows the outline of an area, or of the part, level by level")},
    {PassKind::face, "face", BURIN_TEXT("Pass", "Facing"), BURIN_TEXT("Pass", "Clears the stock above the part")},
    {PassKind::parallel, "parallel", BURIN_TEXT("Pass", "Parallel"),
     BURIN_TEXT("Pass", "Finishing: parallel rows on the part")},
    {PassKind::radial, "radial", BURIN_TEXT("Pass", "Radial"),
     BURIN_TEXT("Pass", "Finishing: rows on the part from the centre outwards")},
    {PassKind::spiral, "spiral", BURIN_TEXT("Pass", "Spiral"),
     BURIN_TEXT("Pass", "Finishing: one spiral row on the part from the centre outwards")},
    {PassKind::flow, "flow", BURIN_TEXT("Pass", "Flow"),
     BURIN_TEXT("Pass",
                "Finishing: rows on the part that follow a stroke, or are blended from one stroke to the next")},
    {PassKind::waterline, "waterline", BURIN_TEXT("Pass", "Waterline"),
     BURIN_TEXT("Pass", "Finishing of steep faces: contours of the part at constant Z")},
    {PassKind::scallop, "scallop", BURIN_TEXT("Pass", "Scallop"),
     BURIN_TEXT("Pass", "Finishing: rows that are evenly far apart on the part, from the border of the area inwards")},
    {PassKind::pencil, "pencil", BURIN_TEXT("Pass", "Pencil"),
     BURIN_TEXT("Pass", "Follows the concave edges of the part")},
    {PassKind::rest, "rest", BURIN_TEXT("Pass", "Rest"),
     BURIN_TEXT("Pass", "Finishing only where stock is left: rows on flat faces, contours on steep ones")},
    {PassKind::engrave, "engrave", BURIN_TEXT("Pass", "Engraving"),
     BURIN_TEXT("Pass", "Cuts along lines at a given depth below the top of the stock")},
    {PassKind::drill, "drill", BURIN_TEXT("Pass", "Drilling"),
     BURIN_TEXT("Pass", "Drills the upright holes of the part that fit the drill, or at given places")},
    {PassKind::thread, "thread", BURIN_TEXT("Pass", "Thread milling"),
     BURIN_TEXT("Pass",
                "Mills threads in drilled holes that are modelled with the thread's major diameter, or on studs "
                "that are modelled with its minor diameter")},
}};

const std::array<std::string_view, 4> handStrokesIds{"ignore", "keep-off", "blend", "extend"};

namespace {

Result<void> within(const char* key, double value, double low, double high) {
    if (value >= low && value <= high) return {};
    return Error{ErrorCode::argumentInvalid, key, formatShortest(value),
                 formatShortest(low) + " to " + formatShortest(high)};
}

bool isInPlan(const glm::dvec2& place) noexcept {
    return std::abs(place.x) <= farthestInPlan && std::abs(place.y) <= farthestInPlan;
}

Result<void> checkArea(const PassRequest& request) {
    for (const PlanRing& ring : request.area.rings) {
        if (ring.size() < 3)
            return Error{ErrorCode::argumentInvalid, "area_mm", std::to_string(ring.size()),
                         "rings of 3 corners at least"};
        for (const glm::dvec2& place : ring)
            if (!isInPlan(place))
                return Error{ErrorCode::argumentInvalid, "area_mm",
                             formatShortest(place.x) + ", " + formatShortest(place.y), "places within 1e5 mm"};
    }
    if (request.area.empty() &&
        (request.kind == PassKind::pocket || (request.kind == PassKind::profile && request.inside)))
        return Error{ErrorCode::argumentInvalid, "area_mm", "none", "an area: there is no pocket without one"};
    return {};
}

Result<void> checkLines(const PassRequest& request) {
    for (const PassLine& line : request.lines) {
        if (line.size() < 2)
            return Error{ErrorCode::argumentInvalid, "lines_mm", std::to_string(line.size()),
                         "lines of 2 places at least"};
        for (const glm::dvec3& place : line)
            if (!isInPlan(place) || !(std::abs(place.z) <= farthestInPlan))
                return Error{ErrorCode::argumentInvalid, "lines_mm",
                             formatShortest(place.x) + ", " + formatShortest(place.y), "places within 1e5 mm"};
    }
    const bool needed =
        request.kind == PassKind::engrave || (request.kind == PassKind::flow && request.hand != HandStrokes::extend);
    if (request.lines.empty() && needed)
        return Error{ErrorCode::argumentInvalid, "lines_mm", "none", "a line at least: a stroke or curves of a file"};
    return {};
}

Result<void> checkPlaces(const PassRequest& request) {
    if (!request.places.empty() && !isInHoles(request.kind))
        return Error{ErrorCode::argumentInvalid, "places_mm", std::string(rowOf(request.kind).id), "drill, thread"};
    for (const glm::dvec2& place : request.places)
        if (!isInPlan(place))
            return Error{ErrorCode::argumentInvalid, "places_mm",
                         formatShortest(place.x) + ", " + formatShortest(place.y), "places within 1e5 mm"};
    return {};
}

/// Tabs and dogbones: rejects them for passes that would ignore them.
Result<void> checkOutline(const PassRequest& request) {
    const std::string id(rowOf(request.kind).id);
    if (request.dogbones && request.kind != PassKind::pocket && request.kind != PassKind::profile)
        return Error{ErrorCode::argumentInvalid, "dogbones", id, "pocket, profile"};
    if (request.tabs == 0) return {};
    if (request.kind != PassKind::profile) return Error{ErrorCode::argumentInvalid, "tabs", id, "profile"};
    if (request.tabs < 0 || request.tabs > mostTabs)
        return Error{ErrorCode::argumentInvalid, "tabs", std::to_string(request.tabs),
                     "0 to " + std::to_string(mostTabs)};
    for (const auto& [key, value] :
         {std::pair{"tab_width_mm", request.tabWidth}, std::pair{"tab_height_mm", request.tabHeight}})
        if (!(value > 0.0)) return Error{ErrorCode::argumentInvalid, key, formatShortest(value), "above 0"};
    return {};
}

/// Threads: rejects the values for passes that would ignore them.
Result<void> checkThread(const PassRequest& request) {
    const auto wrong = [](const char* key, double value, std::string allowed) {
        return Error{ErrorCode::argumentInvalid, key, formatShortest(value), std::move(allowed)};
    };
    if (request.kind != PassKind::thread) {
        for (const auto& [key, isStated] : {std::pair{"pitch_mm", request.pitch != 0.0},
                                            {"major_diameter_mm", request.majorDiameter != 0.0},
                                            {"radial_passes", request.radialPasses != 1},
                                            {"external", request.external},
                                            {"left_hand", request.leftHand},
                                            {"conventional", request.conventional},
                                            {"spring_pass", request.springPass}})
            if (isStated) return Error{ErrorCode::argumentInvalid, key, std::string(rowOf(request.kind).id), "thread"};
        return {};
    }
    if (request.pitch == 0.0) return wrong("pitch_mm", 0.0, "above 0");
    if (request.allowance != 0.0) return wrong("allowance_mm", request.allowance, "0 for a thread");
    if (request.radialPasses < 1 || request.radialPasses > mostRadialPasses)
        return wrong("radial_passes", request.radialPasses, "1 to " + std::to_string(mostRadialPasses));
    if (request.majorDiameter == 0.0 && request.places.empty())
        return wrong("major_diameter_mm", 0.0, "above 0, or the holes or studs of the thread");
    if (request.majorDiameter > 0.0 && request.pitch >= 0.5 * request.majorDiameter)
        return wrong("pitch_mm", request.pitch, "below half of the diameter");
    return {};
}

/// Strokes of the hand: rejects the values for passes that would ignore them.
Result<void> checkHand(const PassRequest& request) {
    const auto refused = [&](const char* key, std::string allowed) -> Result<void> {
        return Error{ErrorCode::argumentInvalid, key,
                     std::string(handStrokesIds[static_cast<std::size_t>(request.hand)]), std::move(allowed)};
    };
    if (request.hand != HandStrokes::ignore && !heedsHandStrokes(request.kind))
        return refused("hand", "ignore: only passes on the surface of the part heed strokes of the hand");
    if (request.hand == HandStrokes::extend && request.kind != PassKind::flow)
        return refused("hand", "ignore, keep-off or blend; only flow extends strokes of the hand");
    if (request.hand == HandStrokes::extend && !request.lines.empty())
        return refused("hand", "no lines to follow: the rows follow the strokes of the path");
    if (request.overlap != 0.0 && request.hand != HandStrokes::blend) return refused("overlap_mm", "blend");
    if (request.finishedWithin != 0.0 && request.hand == HandStrokes::ignore)
        return refused("finished_within_mm", "keep-off, blend or extend");
    std::int64_t led = 0;
    for (const PassLead& lead : request.leads) led += lead.lines;
    if (led > static_cast<std::int64_t>(request.lines.size()))
        return Error{ErrorCode::argumentInvalid, "leads", std::to_string(led),
                     "at most " + std::to_string(request.lines.size()) + ", the number of lines"};
    return {};
}

} // namespace

bool heedsHandStrokes(PassKind kind) noexcept {
    return kind >= PassKind::parallel && kind <= PassKind::rest;
}

bool isInHoles(PassKind kind) noexcept {
    return kind == PassKind::drill || kind == PassKind::thread;
}

HoleWork holeWorkOf(const PassRequest& request) noexcept {
    if (request.kind != PassKind::thread) return HoleWork::drilling;
    return request.external ? HoleWork::externalThreads : HoleWork::internalThreads;
}

const PassKindRow& rowOf(PassKind kind) noexcept {
    return passKinds[static_cast<std::size_t>(kind)];
}

Result<PassKind> passKindWithId(std::string_view id) {
    std::string known;
    for (const PassKindRow& row : passKinds) {
        if (row.id == id) return row.kind;
        known += (known.empty() ? "" : ", ") + std::string(row.id);
    }
    return Error{ErrorCode::nameUnknown, "pass", std::string(id), known};
}

bool PassRequest::allowsSlope(const glm::dvec3& away) const noexcept {
    const double slope = std::acos(std::clamp(away.z, -1.0, 1.0));
    return slope >= flattest && slope <= steepest;
}

Result<void> validate(const PassRequest& request) {
    constexpr double thinnest = 0.01, widest = 1000.0; // mm
    const auto length = [](const char* key, double value, double low) -> Result<void> {
        return value == 0.0 ? Result<void>() : within(key, value, low, widest);
    };
    for (const Result<void>& checked :
         {within("allowance_mm", request.allowance, 0.0, largestAllowance),
          length("step_over_mm", request.stepOver, thinnest),
          length("scallop_mm", request.scallop, 1e-4),
          length("level_depth_mm", request.levelDepth, thinnest),
          length("stairs_mm", request.stairs, thinnest),
          within("direction_rad", request.direction, -10.0, 10.0),
          within("flattest_rad", request.flattest, 0.0, anySlope),
          within("steepest_rad", request.steepest, request.flattest, anySlope),
          within("top_mm", request.top.value_or(0.0), -farthestInPlan, farthestInPlan),
          within("bottom_mm", request.bottom.value_or(0.0), -farthestInPlan, farthestInPlan),
          length("depth_mm", request.depth, thinnest),
          length("tab_width_mm", request.tabWidth, thinnest),
          length("tab_height_mm", request.tabHeight, thinnest),
          length("pitch_mm", request.pitch, 0.1),
          length("major_diameter_mm", request.majorDiameter, 0.5),
          checkArea(request),
          checkLines(request),
          checkPlaces(request),
          checkOutline(request),
          within("overlap_mm", request.overlap, 0.0, 100.0),
          length("finished_within_mm", request.finishedWithin, 0.001),
          within("finished_within_mm", request.finishedWithin, 0.0, 1.0),
          checkHand(request),
          checkThread(request)})
        if (!checked) return checked;
    if (request.top && request.bottom && *request.bottom >= *request.top)
        return Error{ErrorCode::argumentInvalid, "bottom_mm", formatShortest(*request.bottom),
                     "below the top, " + formatShortest(*request.top)};
    if (request.kind == PassKind::engrave && request.depth == 0.0)
        return Error{ErrorCode::argumentInvalid, "depth_mm", "0", "above 0"};
    return {};
}

} // namespace burin
