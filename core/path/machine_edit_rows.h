// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/machine_ranges.h"
#include "core/path/area_fields.h"
#include "core/path/edit_row.h"

#include <tuple>

/// Rows of the table of edits (edit_rows.h).
namespace burin {

template <>
struct EditRow<Link> {
    static constexpr EditTraits traits{.id = "link",
                                       .title = BURIN_TEXT("Edit", "Link"),
                                       .group = EditGroup::links,
                                       .step = EditStep::links,
                                       .once = true,
                                       .approximates = true};
    static constexpr std::array<EditChoice, 3> travels{
        {{"safe", BURIN_TEXT("EditParameterLabels", "full height")},
         {"lowest", BURIN_TEXT("EditParameterLabels", "lowest safe height")},
         {"around", BURIN_TEXT("EditParameterLabels", "around obstacles")}}};
    static constexpr std::array<EditChoice, 2> entries{
        {{"plunge", BURIN_TEXT("EditParameterLabels", "straight down")},
         {"ramp-or-helix", BURIN_TEXT("EditParameterLabels", "a ramp or helix")}}};
    static constexpr std::tuple fields{
        number("clearance_above_mm", &Link::clearanceAbove, 0.1, 1000.0,
               {BURIN_TEXT("EditParameterLabels", "Clearance above"),
                BURIN_TEXT("EditParameterLabels", "Height of rapid moves above the top of the stock")}),
        number("approach_mm", &Link::approach, 0.1, 100.0,
               {BURIN_TEXT("EditParameterLabels", "Approach"),
                BURIN_TEXT("EditParameterLabels", "Height above the remaining stock at which the plunge begins")}),
        choice("travel", &Link::travel, travels,
               {BURIN_TEXT("EditParameterLabels", "Retract"),
                BURIN_TEXT("EditParameterLabels", "Retract: full height, lowest safe height, or around obstacles")}),
        number("rounding_mm", &Link::rounding, 0.0, 100.0,
               {BURIN_TEXT("EditParameterLabels", "Rounding"),
                BURIN_TEXT(
                    "EditParameterLabels",
                    "Largest length of either move that a rounded corner of a link may replace; none: sharp corners")}),
        choice(
            "entry", &Link::entry, entries,
            {BURIN_TEXT("EditParameterLabels", "Into material"),
             BURIN_TEXT("EditParameterLabels", "Entry into a stroke that begins in material: plunge, or a ramp along "
                                               "the stroke, else a helix beside it")}),
        number("ramp_angle_rad", &Link::rampAngle, 0.0, 0.7,
               {BURIN_TEXT("EditParameterLabels", "Ramp angle"),
                BURIN_TEXT("EditParameterLabels",
                           "Largest descent angle of ramps and helices; 0: by material and tool")})};
};
template <>
struct EditRow<SetFeed> {
    static constexpr EditTraits traits{.id = "set-feed",
                                       .title = BURIN_TEXT("Edit", "Set feed and speed"),
                                       .group = EditGroup::feeds,
                                       .step = EditStep::feed,
                                       .once = true};
    static constexpr std::array<EditChoice, 5> coolings{
        {{"advised", BURIN_TEXT("EditParameterLabels", "as advised")},
         {"off", BURIN_TEXT("EditParameterLabels", "off")},
         {"mist", BURIN_TEXT("EditParameterLabels", "mist (M7)")},
         {"flood", BURIN_TEXT("EditParameterLabels", "flood (M8)")},
         {"program", BURIN_TEXT("EditParameterLabels", "as the program states it")}}};
    static constexpr std::array<EditChoice, 2> spindles{
        {{"one", BURIN_TEXT("EditParameterLabels", "one speed")},
         {"by_material", BURIN_TEXT("EditParameterLabels", "by material")}}};
    static constexpr std::array<EditChoice, 2> origins{
        {{"tables", BURIN_TEXT("EditParameterLabels", "from the tables")},
         {"program", BURIN_TEXT("EditParameterLabels", "as the program states them")}}};
    static constexpr std::tuple fields{
        number("speed_factor", &SetFeed::speedFactor, 0.05, 5.0,
               {BURIN_TEXT("EditParameterLabels", "Spindle speed"),
                BURIN_TEXT("EditParameterLabels",
                           "Share of the table value; feeds change with it, the chip load does not")}),
        number("feed_factor", &SetFeed::feedFactor, 0.05, 5.0,
               {BURIN_TEXT("EditParameterLabels", "Chip load"),
                BURIN_TEXT("EditParameterLabels", "Share of the table value; feeds change with it")}),
        choice("coolant", &SetFeed::cooling, coolings,
               {BURIN_TEXT("EditParameterLabels", "Coolant"),
                BURIN_TEXT("EditParameterLabels",
                           "As advised for the material if the machine has it, as chosen here, or as the program "
                           "that the path is made of switches it")}),
        choice("spindle", &SetFeed::spindle, spindles,
               {BURIN_TEXT("EditParameterLabels", "Spindle"),
                BURIN_TEXT("EditParameterLabels",
                           "In several materials: one speed, the least that any of them allows, or the speed of each, "
                           "which changes at their borders; feeds follow in both")}),
        choice("feeds", &SetFeed::feeds, origins,
               {BURIN_TEXT("EditParameterLabels", "Feeds"),
                BURIN_TEXT("EditParameterLabels",
                           "From the tables of tool and material, or as the program states them that the path is made "
                           "of, within the limits of machine and tool; links are fed from the tables, but no faster "
                           "than the moves that they join")})};
};
/// The target of feed optimisation; its unit, and so its key, depends on the goal.
struct LevelTarget {
    EditField of(const FeedOptimisation& edit) const {
        const bool removal = edit.goal == FeedOptimisation::Goal::removal;
        return {removal ? "target_mm3_s" : "target_n",
                {BURIN_TEXT("EditParameterLabels", "Target"),
                 BURIN_TEXT("EditParameterLabels", "0: the mean of the path's cutting moves")},
                edit.target,
                0.0,
                1e6};
    }
    void set(FeedOptimisation& edit, const EditValue& value) const { edit.target = std::get<double>(value); }
};
template <>
struct EditRow<FeedOptimisation> {
    static constexpr EditTraits traits{.id = "level-feed",
                                       .title = BURIN_TEXT("Edit", "Feed by engagement"),
                                       .group = EditGroup::feeds,
                                       .step = EditStep::tuning};
    static constexpr std::array<EditChoice, 3> goals{
        {{"force", BURIN_TEXT("EditParameterLabels", "the force")},
         {"removal", BURIN_TEXT("EditParameterLabels", "the removal rate")},
         {"limits", BURIN_TEXT("EditParameterLabels", "within the limits alone")}}};
    static constexpr std::tuple fields{
        choice("goal", &FeedOptimisation::goal, goals,
               {BURIN_TEXT("EditParameterLabels", "Level"),
                BURIN_TEXT("EditParameterLabels",
                           "Value to keep constant: the force or the removal rate. With the limits, feeds are only "
                           "reduced where the cut exceeds a limit of spindle or tool")}),
        LevelTarget{},
        number("smallest_chip_mm", &FeedOptimisation::smallestChip, 0.0001, 1.0,
               {BURIN_TEXT("EditParameterLabels", "Smallest chip"),
                BURIN_TEXT("EditParameterLabels", "A tooth never takes less")}),
        number("largest_chip_mm", &FeedOptimisation::largestChip, 0.0001, 5.0,
               {BURIN_TEXT("EditParameterLabels", "Largest chip"),
                BURIN_TEXT("EditParameterLabels", "A tooth never takes more")}),
        number("least_change", &FeedOptimisation::leastChange, 0.0, 1.0,
               {BURIN_TEXT("EditParameterLabels", "Least change"),
                BURIN_TEXT("EditParameterLabels", "Change of the feed; smaller changes are left out")}),
        number("sampling_mm", &FeedOptimisation::sampling, 0.05, 10.0,
               {BURIN_TEXT("EditParameterLabels", "Sampling"),
                BURIN_TEXT("EditParameterLabels", "Distance between the points at which moves are evaluated")})};
};
template <>
struct EditRow<AreaFeed> {
    static constexpr EditTraits traits{.id = "area-feed",
                                       .title = BURIN_TEXT("Edit", "Feed in an area"),
                                       .group = EditGroup::feeds,
                                       .step = EditStep::tuning};
    static constexpr std::tuple fields = std::tuple_cat(
        areaFields,
        std::tuple{number("factor", &AreaFeed::factor, 0.05, 5.0,
                          {BURIN_TEXT("EditParameterLabels", "Factor"),
                           BURIN_TEXT("EditParameterLabels", "Feeds inside the area are multiplied by this")})});
};
template <>
struct EditRow<ScaleFeed> {
    static constexpr EditTraits traits{.id = "stroke-feed",
                                       .title = BURIN_TEXT("Edit", "Feed of strokes"),
                                       .group = EditGroup::feeds,
                                       .step = EditStep::tuning};
    static constexpr std::tuple fields{
        interval("stretch", &ScaleFeed::interval, strokesToEdit),
        number("factor", &ScaleFeed::factor, 0.05, 5.0,
               {BURIN_TEXT("EditParameterLabels", "Factor"),
                BURIN_TEXT("EditParameterLabels", "Feeds of these strokes are multiplied by this")})};
};
template <>
struct EditRow<SpindleAndCoolant> {
    static constexpr EditTraits traits{.id = "section",
                                       .title = BURIN_TEXT("Edit", "Spindle and coolant"),
                                       .group = EditGroup::feeds,
                                       .step = EditStep::tuning};
    static constexpr std::array<EditChoice, 4> coolings{{{"kept", BURIN_TEXT("EditParameterLabels", "unchanged")},
                                                         {"off", BURIN_TEXT("EditParameterLabels", "off")},
                                                         {"mist", BURIN_TEXT("EditParameterLabels", "mist (M7)")},
                                                         {"flood", BURIN_TEXT("EditParameterLabels", "flood (M8)")}}};
    static constexpr std::tuple fields{
        interval("stretch", &SpindleAndCoolant::interval, strokesToEdit),
        number("speed_rpm", &SpindleAndCoolant::speed, 0.0, machine_range::spindleSpeed.high,
               {BURIN_TEXT("EditParameterLabels", "Spindle speed"),
                BURIN_TEXT("EditParameterLabels", "Of these strokes; feeds stay as they are. 0: unchanged")}),
        number("speed_factor", &SpindleAndCoolant::factor, 0.05, 5.0,
               {BURIN_TEXT("EditParameterLabels", "Share of the speed"),
                BURIN_TEXT("EditParameterLabels", "Spindle speeds of these strokes are multiplied by this")}),
        choice("coolant", &SpindleAndCoolant::cooling, coolings,
               {BURIN_TEXT("EditParameterLabels", "Coolant"),
                BURIN_TEXT("EditParameterLabels", "Of these strokes, if the machine has it")})};
};

template <>
struct EditRow<ToolAxis> {
    static constexpr EditTraits traits{.id = "tool-axis",
                                       .title = BURIN_TEXT("Edit", "Tool axis"),
                                       .group = EditGroup::surface,
                                       .step = EditStep::axis};
    static constexpr std::array<EditChoice, 4> origins{
        {{"upright", BURIN_TEXT("EditParameterLabels", "upright")},
         {"normal", BURIN_TEXT("EditParameterLabels", "the part's normal")},
         {"fixed", BURIN_TEXT("EditParameterLabels", "a fixed direction")},
         {"program", BURIN_TEXT("EditParameterLabels", "the program")}}};
    static constexpr std::array<EditChoice, 2> ends{
        {{"links", BURIN_TEXT("EditParameterLabels", "turned in the links")},
         {"blend", BURIN_TEXT("EditParameterLabels", "turned in the stroke")}}};
    static constexpr std::array<EditChoice, 2> kept{{{"contact", BURIN_TEXT("EditParameterLabels", "the contact")},
                                                     {"tip", BURIN_TEXT("EditParameterLabels", "the tip")}}};
    static constexpr double steepest = 1.6; // rad, a little more than 90°
    static constexpr std::tuple fields{
        interval("stretch", &ToolAxis::interval, strokesToEdit),
        choice("from", &ToolAxis::from, origins,
               {BURIN_TEXT("EditParameterLabels", "Axis from"),
                BURIN_TEXT("EditParameterLabels",
                           "Direction from which lead and tilt are counted: upright, or the normal of the part; or a "
                           "fixed direction; or the axis that the program states of which the path is made")}),
        number(
            "lead_rad", &ToolAxis::lead, -steepest, steepest,
            {BURIN_TEXT("EditParameterLabels", "Lead"),
             BURIN_TEXT("EditParameterLabels", "Angle in the direction of motion; above 0: the holder leans ahead")}),
        number("tilt_rad", &ToolAxis::tilt, -steepest, steepest,
               {BURIN_TEXT("EditParameterLabels", "Side tilt"),
                BURIN_TEXT("EditParameterLabels",
                           "Angle across the direction of motion; above 0: the holder leans to the left")}),
        number("inclination_rad", &ToolAxis::inclination, 0.0, steepest,
               {BURIN_TEXT("EditParameterLabels", "Inclination"),
                BURIN_TEXT("EditParameterLabels", "Of a fixed direction: its angle from +Z")}),
        number("azimuth_rad", &ToolAxis::azimuth, -6.3, 6.3,
               {BURIN_TEXT("EditParameterLabels", "Towards"),
                BURIN_TEXT("EditParameterLabels",
                           "Of a fixed direction: where the holder leans in plan, anticlockwise from +X")}),
        number("blend_mm", &ToolAxis::blend, 0.1, 1000.0,
               {BURIN_TEXT("EditParameterLabels", "Blend"),
                BURIN_TEXT("EditParameterLabels",
                           "Length over which the axis turns at the borders of the part of the path, and over which "
                           "direction and normal are averaged")}),
        choice("ends", &ToolAxis::ends, ends,
               {BURIN_TEXT("EditParameterLabels", "At ends of strokes"),
                BURIN_TEXT("EditParameterLabels",
                           "Where the axis turns: in the rapids before and after the stroke, or inside it")}),
        choice("keep", &ToolAxis::keep, kept,
               {BURIN_TEXT("EditParameterLabels", "Keep"),
                BURIN_TEXT("EditParameterLabels",
                           "The contact with the part while the tool tilts: the centre of a ball, or the plane that "
                           "another tool touches; or the tip")})};
};

} // namespace burin
