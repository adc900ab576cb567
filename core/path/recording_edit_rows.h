// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/path/area_fields.h"
#include "core/path/edit_row.h"

#include <tuple>

/// Rows of the table of edits (edit_rows.h).
namespace burin {

template <>
struct EditRow<DropAirCuts> {
    static constexpr EditTraits traits{.id = "drop-air-cuts", .title = BURIN_TEXT("Edit", "Drop air cuts")};
    static constexpr std::tuple fields{number("shortest_mm", &DropAirCuts::shortest, 0.0, 1000.0,
                                              {BURIN_TEXT("EditParameterLabels", "Shortest"),
                                               BURIN_TEXT("EditParameterLabels", "Shorter air cuts are kept")})};
};
template <>
struct EditRow<DropDwells> {
    static constexpr EditTraits traits{.id = "drop-dwells", .title = BURIN_TEXT("Edit", "Drop dwells")};
    static constexpr std::tuple fields{
        number("speed_mm_s", &DropDwells::speed, 0.0, 100.0,
               {BURIN_TEXT("EditParameterLabels", "Slower than"),
                BURIN_TEXT("EditParameterLabels", "Tool speed below which the hand counts as resting")}),
        number("time_s", &DropDwells::time, 0.0, 60.0,
               {BURIN_TEXT("EditParameterLabels", "Longer than"),
                BURIN_TEXT("EditParameterLabels", "Shorter dwells are kept")})};
};
template <>
struct EditRow<SmoothShape> {
    static constexpr EditTraits traits{.id = "smooth-shape",
                                       .title = BURIN_TEXT("Edit", "Smooth"),
                                       .group = EditGroup::smoothing,
                                       .approximates = true,
                                       .mayEnter = true};
    static constexpr std::tuple fields{
        number("wavelength_mm", &SmoothShape::wavelength, 0.05, 1000.0,
               {BURIN_TEXT("EditParameterLabels", "Cut-off wavelength"),
                BURIN_TEXT("EditParameterLabels", "Tremor across the path with a shorter wavelength is removed")}),
        number("tolerance_mm", &SmoothShape::tolerance, 0.0, 10.0, recordingTolerance)};
};
template <>
struct EditRow<Smooth> {
    static constexpr EditTraits traits{.id = "smooth",
                                       .title = BURIN_TEXT("Edit", "Smooth in time (earlier version)"),
                                       .group = EditGroup::smoothing,
                                       .approximates = true,
                                       .mayEnter = true,
                                       .superseded = true};
    static constexpr std::tuple fields{number("cut_off_hz", &Smooth::cutOff, 0.1, 500.0, cutOffFrequency),
                                       number("tolerance_mm", &Smooth::tolerance, 0.0, 10.0, recordingTolerance)};
};
template <>
struct EditRow<SmoothSpline> {
    static constexpr EditTraits traits{.id = "smooth-spline",
                                       .title = BURIN_TEXT("Edit", "Smooth by a spline in time (earlier version)"),
                                       .group = EditGroup::smoothing,
                                       .approximates = true,
                                       .mayEnter = true,
                                       .superseded = true};
    static constexpr std::tuple fields{number("cut_off_hz", &SmoothSpline::cutOff, 0.1, 500.0, cutOffFrequency),
                                       number("tolerance_mm", &SmoothSpline::tolerance, 0.0, 10.0, recordingTolerance)};
};
template <>
struct EditRow<CutOut> {
    static constexpr EditTraits traits{.id = "cut-out", .title = BURIN_TEXT("Edit", "Delete part of the path")};
    static constexpr std::tuple fields{
        interval("stretch", &CutOut::interval,
                 {BURIN_TEXT("EditParameterLabels", "Applies to"),
                  BURIN_TEXT("EditParameterLabels", "Part of the path to delete. Select it in the view first")})};
};
template <>
struct EditRow<Trim> {
    static constexpr EditTraits traits{.id = "trim", .title = BURIN_TEXT("Edit", "Trim")};
    static constexpr std::tuple fields{interval("stretch", &Trim::interval, strokesToEdit),
                                       number("from_start_mm", &Trim::fromStart, 0.0, 10000.0,
                                              {BURIN_TEXT("EditParameterLabels", "From the start"),
                                               BURIN_TEXT("EditParameterLabels", "Cut off where each stroke begins")}),
                                       number("from_end_mm", &Trim::fromEnd, 0.0, 10000.0,
                                              {BURIN_TEXT("EditParameterLabels", "From the end"),
                                               BURIN_TEXT("EditParameterLabels", "Cut off where each stroke ends")})};
};
template <>
struct EditRow<Extend> {
    static constexpr EditTraits traits{.id = "extend", .title = BURIN_TEXT("Edit", "Extend"), .mayEnter = true};
    static constexpr std::tuple fields{
        interval("stretch", &Extend::interval, strokesToEdit),
        number("at_start_mm", &Extend::atStart, 0.0, 1000.0,
               {BURIN_TEXT("EditParameterLabels", "At the start"),
                BURIN_TEXT("EditParameterLabels", "Added straight before the start of each stroke")}),
        number("at_end_mm", &Extend::atEnd, 0.0, 1000.0,
               {BURIN_TEXT("EditParameterLabels", "At the end"),
                BURIN_TEXT("EditParameterLabels", "Added straight behind the end of each stroke")})};
};
template <>
struct EditRow<Split> {
    static constexpr EditTraits traits{.id = "split", .title = BURIN_TEXT("Edit", "Split")};
    static constexpr std::tuple fields{moment("at", &Split::at,
                                              {BURIN_TEXT("EditParameterLabels", "Position"),
                                               BURIN_TEXT("EditParameterLabels", "The stroke is split here")})};
};
template <>
struct EditRow<Join> {
    static constexpr EditTraits traits{.id = "join", .title = BURIN_TEXT("Edit", "Join"), .mayEnter = true};
    static constexpr std::tuple fields{
        interval("stretch", &Join::interval, strokesToEdit),
        number("longest_mm", &Join::longest, 0.0, 1000.0,
               {BURIN_TEXT("EditParameterLabels", "Largest gap"),
                BURIN_TEXT("EditParameterLabels", "Ends no farther apart than this are joined")})};
};
template <>
struct EditRow<Reorder> {
    static constexpr EditTraits traits{
        .id = "reorder", .title = BURIN_TEXT("Edit", "Reorder"), .group = EditGroup::arrangement};
    static constexpr std::tuple fields{
        moment("stroke", &Reorder::stroke,
               {BURIN_TEXT("EditParameterLabels", "Stroke"),
                BURIN_TEXT("EditParameterLabels", "The stroke that is moved in the order")}),
        moment("before", &Reorder::before,
               {BURIN_TEXT("EditParameterLabels", "Before"),
                BURIN_TEXT("EditParameterLabels", "The stroke that it comes before; none: it comes last")})};
};
template <>
struct EditRow<Reverse> {
    static constexpr EditTraits traits{
        .id = "reverse", .title = BURIN_TEXT("Edit", "Reverse"), .group = EditGroup::arrangement};
    static constexpr std::tuple fields{interval("stretch", &Reverse::interval, strokesToEdit)};
};
template <>
struct EditRow<Mirror> {
    static constexpr EditTraits traits{
        .id = "mirror", .title = BURIN_TEXT("Edit", "Mirror"), .group = EditGroup::arrangement, .mayEnter = true};
    static constexpr std::array<EditChoice, 2> planes{
        {{"x", BURIN_TEXT("EditParameterLabels", "X")}, {"y", BURIN_TEXT("EditParameterLabels", "Y")}}};
    static constexpr std::tuple fields{
        interval("stretch", &Mirror::interval, strokesToEdit),
        choice("across", &Mirror::across, planes,
               {BURIN_TEXT("EditParameterLabels", "Across"),
                BURIN_TEXT("EditParameterLabels", "Axis perpendicular to the mirror plane")}),
        number("at_mm", &Mirror::at, -farthestPlace, farthestPlace,
               {BURIN_TEXT("EditParameterLabels", "Plane at"),
                BURIN_TEXT("EditParameterLabels",
                           "Position of the mirror plane, from program zero; it can be drawn in the view, as a line")}),
        onOff("keep", &Mirror::keep,
              {BURIN_TEXT("EditParameterLabels", "Keep the originals"),
               BURIN_TEXT("EditParameterLabels", "They are cut before their images")})};
};
template <>
struct EditRow<Rotate> {
    static constexpr EditTraits traits{
        .id = "rotate", .title = BURIN_TEXT("Edit", "Rotate"), .group = EditGroup::arrangement, .mayEnter = true};
    static constexpr std::tuple fields{interval("stretch", &Rotate::interval, strokesToEdit),
                                       place("centre_mm", &Rotate::centre, turnCentre),
                                       number("angle_rad", &Rotate::angle, -2.0 * pi, 2.0 * pi,
                                              {BURIN_TEXT("EditParameterLabels", "Angle"),
                                               BURIN_TEXT("EditParameterLabels", "Anticlockwise as seen from above")})};
};
template <>
struct EditRow<Array> {
    static constexpr EditTraits traits{
        .id = "array", .title = BURIN_TEXT("Edit", "Array"), .group = EditGroup::arrangement, .mayEnter = true};
    static constexpr std::tuple fields{
        interval("stretch", &Array::interval, strokesToEdit),
        place("step_mm", &Array::step,
              {BURIN_TEXT("EditParameterLabels", "Step"),
               BURIN_TEXT("EditParameterLabels", "From each copy to the next")}),
        place("centre_mm", &Array::centre, turnCentre),
        number("turn_rad", &Array::turn, -2.0 * pi, 2.0 * pi,
               {BURIN_TEXT("EditParameterLabels", "Rotation"),
                BURIN_TEXT("EditParameterLabels", "From each copy to the next, anticlockwise as seen from above")}),
        count(
            "copies", &Array::copies, 1.0, 1000.0,
            {BURIN_TEXT("EditParameterLabels", "Copies"), BURIN_TEXT("EditParameterLabels", "Besides the original")})};
};
template <>
struct EditRow<MovePoints> {
    static constexpr EditTraits traits{
        .id = "move-points", .title = BURIN_TEXT("Edit", "Move points"), .group = EditGroup::places, .mayEnter = true};
    static constexpr std::array<EditChoice, 2> ways{
        {{"free", BURIN_TEXT("EditParameterLabels", "freely")},
         {"surface", BURIN_TEXT("EditParameterLabels", "the part's surface")}}};
    static constexpr std::tuple fields{
        interval("stretch", &MovePoints::interval,
                 {BURIN_TEXT("EditParameterLabels", "Applies to"),
                  BURIN_TEXT("EditParameterLabels", "Points that are moved")}),
        place(
            "by_mm", &MovePoints::by,
            {BURIN_TEXT("EditParameterLabels", "By"), BURIN_TEXT("EditParameterLabels", "Displacement of the points")}),
        number("falloff_mm", &MovePoints::falloff, 0.0, 1000.0,
               {BURIN_TEXT("EditParameterLabels", "Falloff"),
                BURIN_TEXT("EditParameterLabels",
                           "Points along the stroke within this distance follow by less and less")}),
        choice(
            "along", &MovePoints::along, ways,
            {BURIN_TEXT("EditParameterLabels", "Along"),
             BURIN_TEXT("EditParameterLabels", "Freely, or along the part's surface with the same distance from it")})};
};
template <>
struct EditRow<InsertPoint> {
    static constexpr EditTraits traits{.id = "insert-point",
                                       .title = BURIN_TEXT("Edit", "Insert a point"),
                                       .group = EditGroup::places,
                                       .mayEnter = true};
    static constexpr std::array<EditChoice, 2> forms{{{"smooth", BURIN_TEXT("EditParameterLabels", "smooth")},
                                                      {"corner", BURIN_TEXT("EditParameterLabels", "corner")}}};
    static constexpr std::tuple fields{
        moment("at", &InsertPoint::at,
               {BURIN_TEXT("EditParameterLabels", "Position"),
                BURIN_TEXT("EditParameterLabels", "The point is inserted here. Select a point of the path first")}),
        number("beyond_mm", &InsertPoint::beyond, 0.0, farthestPlace,
               {BURIN_TEXT("EditParameterLabels", "Farther along"),
                BURIN_TEXT("EditParameterLabels", "Distance along the stroke from that position to the point")}),
        place("by_mm", &InsertPoint::by,
              {BURIN_TEXT("EditParameterLabels", "By"),
               BURIN_TEXT("EditParameterLabels", "Displacement of the point from the stroke")}),
        number(
            "length_mm", &InsertPoint::length, 0.0, 1000.0,
            {BURIN_TEXT("EditParameterLabels", "Blend"),
             BURIN_TEXT("EditParameterLabels",
                        "The stroke follows the point within this length on either side; 0: the point alone moves")}),
        choice("form", &InsertPoint::form, forms,
               {BURIN_TEXT("EditParameterLabels", "Form"),
                BURIN_TEXT("EditParameterLabels",
                           "How the stroke leads to the point: in a smooth curve, or in straight lines to a corner")})};
};
template <>
struct EditRow<ReplaceInterval> {
    static constexpr EditTraits traits{.id = "replace-stretch",
                                       .title = BURIN_TEXT("Edit", "Replace part of the path"),
                                       .group = EditGroup::places,
                                       .mayEnter = true};
    static constexpr std::tuple fields{
        interval("stretch", &ReplaceInterval::interval,
                 {BURIN_TEXT("EditParameterLabels", "Applies to"),
                  BURIN_TEXT("EditParameterLabels", "Part of the path that the drawn stroke replaces")}),
        places("places_mm", &ReplaceInterval::places, 2.0,
               {BURIN_TEXT("EditParameterLabels", "Points"),
                BURIN_TEXT("EditParameterLabels", "Points of the drawn stroke")})};
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
    static constexpr std::tuple fields = std::tuple_cat(
        areaFields,
        std::tuple{number("lift_mm", &LiftArea::lift, 0.0, 1000.0,
                          {BURIN_TEXT("EditParameterLabels", "Retract"),
                           BURIN_TEXT("EditParameterLabels", "Height of the retraction inside the area")})});
};
template <>
struct EditRow<KeepTabs> {
    static constexpr EditTraits traits{
        .id = "tabs", .title = BURIN_TEXT("Edit", "Holding tabs"), .group = EditGroup::places, .mayEnter = true};
    static constexpr std::tuple fields{
        places("places_mm", &KeepTabs::places, 1.0,
               {BURIN_TEXT("EditParameterLabels", "Points"),
                BURIN_TEXT("EditParameterLabels",
                           "Points in plan at which the path leaves a tab. Draw them in the view")}),
        number("width_mm", &KeepTabs::width, 0.1, 100.0,
               {BURIN_TEXT("EditParameterLabels", "Width"),
                BURIN_TEXT("EditParameterLabels", "Width of the tab that the cutter leaves")}),
        number("height_mm", &KeepTabs::height, 0.05, 100.0,
               {BURIN_TEXT("EditParameterLabels", "Height"),
                BURIN_TEXT("EditParameterLabels", "Height of the tab above the lowest stroke there")})};
};

} // namespace burin
