// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/path/edit_field.h"
#include "core/path/edit_step.h"

#include <tuple>

/// The table of all kinds of edits, a row each: id, title, step, what it does to the path's guarantees, parameters.
/// Files, validation, the order and the user interface read it here.
namespace burin {

template <class T>
struct EditRow;

/// What every area has.
inline constexpr std::tuple areaFields{places("outline_mm", &Area::outline, 3.0),
                                       number("low_mm", &Area::low, -farthestPlace, farthestPlace),
                                       number("high_mm", &Area::high, -farthestPlace, farthestPlace)};

template <>
struct EditRow<DropAirCuts> {
    static constexpr EditTraits traits{.id = "drop-air-cuts", .title = BURIN_TEXT("Edit", "Drop air cuts")};
    static constexpr std::tuple fields{number("shortest_mm", &DropAirCuts::shortest, 0.0, 1000.0)};
};
template <>
struct EditRow<DropDwells> {
    static constexpr EditTraits traits{.id = "drop-dwells", .title = BURIN_TEXT("Edit", "Drop dwells")};
    static constexpr std::tuple fields{number("speed_mm_s", &DropDwells::speed, 0.0, 100.0),
                                       number("time_s", &DropDwells::time, 0.0, 60.0)};
};
template <>
struct EditRow<SmoothShape> {
    static constexpr EditTraits traits{.id = "smooth-shape",
                                       .title = BURIN_TEXT("Edit", "Smooth"),
                                       .group = EditGroup::smoothing,
                                       .approximates = true,
                                       .mayEnter = true};
    static constexpr std::tuple fields{number("wavelength_mm", &SmoothShape::wavelength, 0.05, 1000.0),
                                       number("tolerance_mm", &SmoothShape::tolerance, 0.0, 10.0)};
};
template <>
struct EditRow<Smooth> {
    static constexpr EditTraits traits{.id = "smooth",
                                       .title = BURIN_TEXT("Edit", "Smooth in time (earlier version)"),
                                       .group = EditGroup::smoothing,
                                       .approximates = true,
                                       .mayEnter = true,
                                       .superseded = true};
    static constexpr std::tuple fields{number("cut_off_hz", &Smooth::cutOff, 0.1, 500.0),
                                       number("tolerance_mm", &Smooth::tolerance, 0.0, 10.0)};
};
template <>
struct EditRow<SmoothSpline> {
    static constexpr EditTraits traits{.id = "smooth-spline",
                                       .title = BURIN_TEXT("Edit", "Smooth by a spline in time (earlier version)"),
                                       .group = EditGroup::smoothing,
                                       .approximates = true,
                                       .mayEnter = true,
                                       .superseded = true};
    static constexpr std::tuple fields{number("cut_off_hz", &SmoothSpline::cutOff, 0.1, 500.0),
                                       number("tolerance_mm", &SmoothSpline::tolerance, 0.0, 10.0)};
};
template <>
struct EditRow<CutOut> {
    static constexpr EditTraits traits{.id = "cut-out", .title = BURIN_TEXT("Edit", "Delete part of the path")};
    static constexpr std::tuple fields{stretch("stretch", &CutOut::stretch)};
};
template <>
struct EditRow<Trim> {
    static constexpr EditTraits traits{.id = "trim", .title = BURIN_TEXT("Edit", "Trim")};
    static constexpr std::tuple fields{stretch("stretch", &Trim::stretch),
                                       number("from_start_mm", &Trim::fromStart, 0.0, 10000.0),
                                       number("from_end_mm", &Trim::fromEnd, 0.0, 10000.0)};
};
template <>
struct EditRow<Split> {
    static constexpr EditTraits traits{.id = "split", .title = BURIN_TEXT("Edit", "Split")};
    static constexpr std::tuple fields{moment("at", &Split::at)};
};
template <>
struct EditRow<Join> {
    static constexpr EditTraits traits{.id = "join", .title = BURIN_TEXT("Edit", "Join"), .mayEnter = true};
    static constexpr std::tuple fields{stretch("stretch", &Join::stretch),
                                       number("longest_mm", &Join::longest, 0.0, 1000.0)};
};
template <>
struct EditRow<Reorder> {
    static constexpr EditTraits traits{
        .id = "reorder", .title = BURIN_TEXT("Edit", "Reorder"), .group = EditGroup::arrangement};
    static constexpr std::tuple fields{moment("stroke", &Reorder::stroke), moment("before", &Reorder::before)};
};
template <>
struct EditRow<Reverse> {
    static constexpr EditTraits traits{
        .id = "reverse", .title = BURIN_TEXT("Edit", "Reverse"), .group = EditGroup::arrangement};
    static constexpr std::tuple fields{stretch("stretch", &Reverse::stretch)};
};
template <>
struct EditRow<Mirror> {
    static constexpr EditTraits traits{
        .id = "mirror", .title = BURIN_TEXT("Edit", "Mirror"), .group = EditGroup::arrangement, .mayEnter = true};
    static constexpr std::array<std::string_view, 2> planes{"x", "y"};
    static constexpr std::tuple fields{stretch("stretch", &Mirror::stretch), choice("across", &Mirror::across, planes),
                                       number("at_mm", &Mirror::at, -farthestPlace, farthestPlace),
                                       onOff("keep", &Mirror::keep)};
};
template <>
struct EditRow<Rotate> {
    static constexpr EditTraits traits{
        .id = "rotate", .title = BURIN_TEXT("Edit", "Rotate"), .group = EditGroup::arrangement, .mayEnter = true};
    static constexpr std::tuple fields{stretch("stretch", &Rotate::stretch), place("centre_mm", &Rotate::centre),
                                       number("angle_rad", &Rotate::angle, -2.0 * pi, 2.0 * pi)};
};
template <>
struct EditRow<Array> {
    static constexpr EditTraits traits{
        .id = "array", .title = BURIN_TEXT("Edit", "Array"), .group = EditGroup::arrangement, .mayEnter = true};
    static constexpr std::tuple fields{
        stretch("stretch", &Array::stretch), place("step_mm", &Array::step), place("centre_mm", &Array::centre),
        number("turn_rad", &Array::turn, -2.0 * pi, 2.0 * pi), count("copies", &Array::copies, 1.0, 1000.0)};
};
template <>
struct EditRow<MovePoints> {
    static constexpr EditTraits traits{
        .id = "move-points", .title = BURIN_TEXT("Edit", "Move points"), .group = EditGroup::places, .mayEnter = true};
    static constexpr std::array<std::string_view, 2> ways{"free", "surface"};
    static constexpr std::tuple fields{stretch("stretch", &MovePoints::stretch), place("by_mm", &MovePoints::by),
                                       number("falloff_mm", &MovePoints::falloff, 0.0, 1000.0),
                                       choice("along", &MovePoints::along, ways)};
};
template <>
struct EditRow<ReplaceStretch> {
    static constexpr EditTraits traits{.id = "replace-stretch",
                                       .title = BURIN_TEXT("Edit", "Replace part of the path"),
                                       .group = EditGroup::places,
                                       .mayEnter = true};
    static constexpr std::tuple fields{stretch("stretch", &ReplaceStretch::stretch),
                                       places("places_mm", &ReplaceStretch::places, 2.0)};
};
template <>
struct EditRow<RemoveArea> {
    static constexpr EditTraits traits{
        .id = "remove-area", .title = BURIN_TEXT("Edit", "Delete in an area"), .group = EditGroup::places};
    static constexpr std::tuple fields = areaFields;
};
template <>
struct EditRow<LiftArea> {
    static constexpr EditTraits traits{.id = "lift-area",
                                       .title = BURIN_TEXT("Edit", "Retract in an area"),
                                       .group = EditGroup::places,
                                       .mayEnter = true};
    static constexpr std::tuple fields =
        std::tuple_cat(areaFields, std::tuple{number("lift_mm", &LiftArea::lift, 0.0, 1000.0)});
};
template <>
struct EditRow<HoldOut> {
    static constexpr EditTraits traits{.id = "hold-out",
                                       .title = BURIN_TEXT("Edit", "Keep out of the part"),
                                       .group = EditGroup::surface,
                                       .step = EditStep::surface,
                                       .approximates = true,
                                       .holdsOut = true};
    static constexpr std::tuple fields{number("clearance_mm", &HoldOut::clearance, 0.001, 10.0),
                                       number("sampling_mm", &HoldOut::sampling, 0.005, 1.0)};
};
template <>
struct EditRow<LayOnPart> {
    static constexpr EditTraits traits{.id = "project",
                                       .title = BURIN_TEXT("Edit", "Project onto the part"),
                                       .group = EditGroup::surface,
                                       .step = EditStep::surface,
                                       .holdsOut = true};
    static constexpr std::array<std::string_view, 2> ways{"axis", "normal"};
    static constexpr std::tuple fields{number("allowance_mm", &LayOnPart::allowance, 0.0, 100.0),
                                       number("sampling_mm", &LayOnPart::sampling, 0.01, 1.0),
                                       choice("along", &LayOnPart::along, ways)};
};
template <>
struct EditRow<Offset> {
    static constexpr EditTraits traits{.id = "offset",
                                       .title = BURIN_TEXT("Edit", "Offset"),
                                       .group = EditGroup::surface,
                                       .step = EditStep::surface,
                                       .mayEnter = true};
    static constexpr std::tuple fields{stretch("stretch", &Offset::stretch),
                                       number("distance_mm", &Offset::distance, -1000.0, 1000.0)};
};
template <>
struct EditRow<StepOverRows> {
    static constexpr EditTraits traits{.id = "guide-rows",
                                       .title = BURIN_TEXT("Edit", "Rows along a guide"),
                                       .group = EditGroup::surface,
                                       .step = EditStep::surface,
                                       .holdsOut = true};
    static constexpr std::tuple fields{stretch("stretch", &StepOverRows::stretch),
                                       places("guide_mm", &StepOverRows::guide, 2.0),
                                       number("step_over_mm", &StepOverRows::stepOver, 0.005, 100.0),
                                       count("left", &StepOverRows::left, 0.0, 1000.0),
                                       count("right", &StepOverRows::right, 0.0, 1000.0),
                                       number("allowance_mm", &StepOverRows::allowance, 0.0, 100.0)};
};
template <>
struct EditRow<Simplify> {
    static constexpr EditTraits traits{.id = "simplify",
                                       .title = BURIN_TEXT("Edit", "Simplify"),
                                       .group = EditGroup::smoothing,
                                       .step = EditStep::surface,
                                       .approximates = true};
    static constexpr std::tuple fields{number("tolerance_mm", &Simplify::tolerance, 0.0, 10.0)};
};
template <>
struct EditRow<FitArcs> {
    static constexpr EditTraits traits{.id = "fit-arcs",
                                       .title = BURIN_TEXT("Edit", "Fit arcs"),
                                       .group = EditGroup::smoothing,
                                       .step = EditStep::curves,
                                       .approximates = true};
    static constexpr std::tuple fields{number("tolerance_mm", &FitArcs::tolerance, 0.0002, 1.0),
                                       number("largest_sweep_rad", &FitArcs::largestSweep, 0.1, pi),
                                       number("smallest_radius_mm", &FitArcs::smallestRadius, 0.01, 100.0),
                                       number("largest_radius_mm", &FitArcs::largestRadius, 0.1, 10000.0),
                                       number("radius_mismatch_mm", &FitArcs::radiusMismatch, 0.0001, 0.1)};
};
template <>
struct EditRow<RoundCorners> {
    static constexpr EditTraits traits{.id = "round-corners",
                                       .title = BURIN_TEXT("Edit", "Round corners"),
                                       .group = EditGroup::smoothing,
                                       .step = EditStep::curves,
                                       .approximates = true};
    static constexpr std::tuple fields{number("tolerance_mm", &RoundCorners::tolerance, 0.001, 10.0),
                                       number("smallest_turn_rad", &RoundCorners::smallestTurn, 0.001, 3.0)};
};
inline constexpr std::array<std::string_view, 2> leadDirections{"first-move", "recording"};
template <>
struct EditRow<LeadIn> {
    static constexpr EditTraits traits{
        .id = "lead-in", .title = BURIN_TEXT("Edit", "Lead in"), .group = EditGroup::links, .step = EditStep::ends};
    static constexpr std::array<std::string_view, 4> forms{"line", "arc", "ramp", "helix"};
    static constexpr std::tuple fields{stretch("stretch", &LeadIn::stretch),
                                       choice("form", &LeadIn::form, forms),
                                       number("size_mm", &LeadIn::size, 0.05, 1000.0),
                                       number("height_mm", &LeadIn::height, 0.01, 1000.0),
                                       number("angle_rad", &LeadIn::angle, 0.002, 1.2),
                                       choice("direction", &LeadIn::direction, leadDirections)};
};
template <>
struct EditRow<LeadOut> {
    static constexpr EditTraits traits{
        .id = "lead-out", .title = BURIN_TEXT("Edit", "Lead out"), .group = EditGroup::links, .step = EditStep::ends};
    static constexpr std::array<std::string_view, 2> forms{"line", "arc"};
    static constexpr std::tuple fields{stretch("stretch", &LeadOut::stretch), choice("form", &LeadOut::form, forms),
                                       number("size_mm", &LeadOut::size, 0.05, 1000.0),
                                       choice("direction", &LeadOut::direction, leadDirections)};
};
template <>
struct EditRow<Link> {
    static constexpr EditTraits traits{.id = "link",
                                       .title = BURIN_TEXT("Edit", "Link"),
                                       .group = EditGroup::links,
                                       .step = EditStep::links,
                                       .once = true,
                                       .approximates = true};
    static constexpr std::array<std::string_view, 3> travels{"safe", "lowest", "around"};
    static constexpr std::array<std::string_view, 2> entries{"plunge", "ramp-or-helix"};
    static constexpr std::tuple fields{number("clearance_above_mm", &Link::clearanceAbove, 0.1, 1000.0),
                                       number("approach_mm", &Link::approach, 0.1, 100.0),
                                       choice("travel", &Link::travel, travels),
                                       number("rounding_mm", &Link::rounding, 0.0, 100.0),
                                       choice("entry", &Link::entry, entries),
                                       number("ramp_angle_rad", &Link::rampAngle, 0.0, 0.7)};
};
template <>
struct EditRow<SetFeed> {
    static constexpr EditTraits traits{.id = "set-feed",
                                       .title = BURIN_TEXT("Edit", "Set feed and speed"),
                                       .group = EditGroup::feeds,
                                       .step = EditStep::feed,
                                       .once = true};
    static constexpr std::array<std::string_view, 4> coolings{"advised", "off", "mist", "flood"};
    static constexpr std::tuple fields{number("speed_factor", &SetFeed::speedFactor, 0.05, 5.0),
                                       number("feed_factor", &SetFeed::feedFactor, 0.05, 5.0),
                                       choice("coolant", &SetFeed::cooling, coolings)};
};

template <>
struct EditRow<LevelFeed> {
    static constexpr EditTraits traits{.id = "level-feed",
                                       .title = BURIN_TEXT("Edit", "Feed by engagement"),
                                       .group = EditGroup::feeds,
                                       .step = EditStep::tuning};
    static constexpr std::array<std::string_view, 3> goals{"force", "removal", "limits"};
    static constexpr std::tuple fields{choice("goal", &LevelFeed::goal, goals),
                                       number("target", &LevelFeed::target, 0.0, 1e6),
                                       number("smallest_chip_mm", &LevelFeed::smallestChip, 0.0001, 1.0),
                                       number("largest_chip_mm", &LevelFeed::largestChip, 0.0001, 5.0),
                                       number("least_change", &LevelFeed::leastChange, 0.0, 1.0),
                                       number("sampling_mm", &LevelFeed::sampling, 0.05, 10.0)};
};
template <>
struct EditRow<AreaFeed> {
    static constexpr EditTraits traits{.id = "area-feed",
                                       .title = BURIN_TEXT("Edit", "Feed in an area"),
                                       .group = EditGroup::feeds,
                                       .step = EditStep::tuning};
    static constexpr std::tuple fields =
        std::tuple_cat(areaFields, std::tuple{number("factor", &AreaFeed::factor, 0.05, 5.0)});
};

} // namespace burin
