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
        {{"safe", BURIN_TEXT("EditParameterTexts", "full height")},
         {"lowest", BURIN_TEXT("EditParameterTexts", "lowest safe height")},
         {"around", BURIN_TEXT("EditParameterTexts", "around obstacles")}}};
    static constexpr std::array<EditChoice, 2> entries{
        {{"plunge", BURIN_TEXT("EditParameterTexts", "straight down")},
         {"ramp-or-helix", BURIN_TEXT("EditParameterTexts", "a ramp or helix")}}};
    static constexpr std::tuple fields{
        number("clearance_above_mm", &Link::clearanceAbove, 0.1, 1000.0,
               {BURIN_TEXT("EditParameterTexts", "Clearance above"),
                BURIN_TEXT("EditParameterTexts", "Height of rapid moves above the top of the stock")}),
        number("approach_mm", &Link::approach, 0.1, 100.0,
               {BURIN_TEXT("EditParameterTexts", "Approach"),
                BURIN_TEXT("EditParameterTexts", "Height above the remaining stock at which the plunge begins")}),
        choice("travel", &Link::travel, travels,
               {BURIN_TEXT("EditParameterTexts", "Retract"),
                BURIN_TEXT("EditParameterTexts", "Retract: full height, lowest safe height, or around obstacles")}),
        number("rounding_mm", &Link::rounding, 0.0, 100.0,
               {BURIN_TEXT("EditParameterTexts", "Rounding"),
                BURIN_TEXT(
                    "EditParameterTexts",
                    "Largest length of either move that a rounded corner of a link may replace; none: sharp corners")}),
        choice("entry", &Link::entry, entries,
               {BURIN_TEXT("EditParameterTexts", "Into material"),
                BURIN_TEXT("EditParameterTexts", "Entry into a stroke that begins in material: plunge, or a ramp along "
                                                 "the stroke, else a helix beside it")}),
        number(
            "ramp_angle_rad", &Link::rampAngle, 0.0, 0.7,
            {BURIN_TEXT("EditParameterTexts", "Ramp angle"),
             BURIN_TEXT("EditParameterTexts", "Largest descent angle of ramps and helices; 0: by material and tool")})};
};
template <>
struct EditRow<SetFeed> {
    static constexpr EditTraits traits{.id = "set-feed",
                                       .title = BURIN_TEXT("Edit", "Set feed and speed"),
                                       .group = EditGroup::feeds,
                                       .step = EditStep::feed,
                                       .once = true};
    static constexpr std::array<EditChoice, 4> coolings{{{"advised", BURIN_TEXT("EditParameterTexts", "as advised")},
                                                         {"off", BURIN_TEXT("EditParameterTexts", "off")},
                                                         {"mist", BURIN_TEXT("EditParameterTexts", "mist (M7)")},
                                                         {"flood", BURIN_TEXT("EditParameterTexts", "flood (M8)")}}};
    static constexpr std::array<EditChoice, 2> spindles{
        {{"one", BURIN_TEXT("EditParameterTexts", "one speed")},
         {"by_material", BURIN_TEXT("EditParameterTexts", "by material")}}};
    static constexpr std::array<EditChoice, 2> origins{
        {{"tables", BURIN_TEXT("EditParameterTexts", "from the tables")},
         {"program", BURIN_TEXT("EditParameterTexts", "as the program states them")}}};
    static constexpr std::tuple fields{
        number("speed_factor", &SetFeed::speedFactor, 0.05, 5.0,
               {BURIN_TEXT("EditParameterTexts", "Spindle speed"),
                BURIN_TEXT("EditParameterTexts",
                           "Share of the table value; feeds change with it, the chip load does not")}),
        number("feed_factor", &SetFeed::feedFactor, 0.05, 5.0,
               {BURIN_TEXT("EditParameterTexts", "Chip load"),
                BURIN_TEXT("EditParameterTexts", "Share of the table value; feeds change with it")}),
        choice(
            "coolant", &SetFeed::cooling, coolings,
            {BURIN_TEXT("EditParameterTexts", "Coolant"),
             BURIN_TEXT("EditParameterTexts", "As advised for the material if the machine has it, or as chosen here")}),
        choice("spindle", &SetFeed::spindle, spindles,
               {BURIN_TEXT("EditParameterTexts", "Spindle"),
                BURIN_TEXT("EditParameterTexts",
                           "In several materials: one speed, the least that any of them allows, or the speed of each, "
                           "which changes at their borders; feeds follow in both")}),
        choice("feeds", &SetFeed::feeds, origins,
               {BURIN_TEXT("EditParameterTexts", "Feeds"),
                BURIN_TEXT("EditParameterTexts",
                           "From the tables of tool and material, or as the program states them that the path is made "
                           "of, within the limits of machine and tool; links are fed from the tables, but no faster "
                           "than the moves that they join")})};
};
/// The target of feed optimisation; its unit, and so its key, depends on the goal.
struct LevelTarget {
    EditField of(const LevelFeed& edit) const {
        const bool removal = edit.goal == LevelFeed::Goal::removal;
        return {removal ? "target_mm3_s" : "target_n",
                {BURIN_TEXT("EditParameterTexts", "Target"),
                 BURIN_TEXT("EditParameterTexts", "0: the mean of the path's cutting moves")},
                edit.target,
                0.0,
                1e6};
    }
    void set(LevelFeed& edit, const EditValue& value) const { edit.target = std::get<double>(value); }
};
template <>
struct EditRow<LevelFeed> {
    static constexpr EditTraits traits{.id = "level-feed",
                                       .title = BURIN_TEXT("Edit", "Feed by engagement"),
                                       .group = EditGroup::feeds,
                                       .step = EditStep::tuning};
    static constexpr std::array<EditChoice, 3> goals{
        {{"force", BURIN_TEXT("EditParameterTexts", "the force")},
         {"removal", BURIN_TEXT("EditParameterTexts", "the removal rate")},
         {"limits", BURIN_TEXT("EditParameterTexts", "within the limits alone")}}};
    static constexpr std::tuple fields{
        choice("goal", &LevelFeed::goal, goals,
               {BURIN_TEXT("EditParameterTexts", "Level"),
                BURIN_TEXT("EditParameterTexts",
                           "Value to keep constant: the force or the removal rate. With the limits, feeds are only "
                           "reduced where the cut exceeds a limit of spindle or tool")}),
        LevelTarget{},
        number("smallest_chip_mm", &LevelFeed::smallestChip, 0.0001, 1.0,
               {BURIN_TEXT("EditParameterTexts", "Smallest chip"),
                BURIN_TEXT("EditParameterTexts", "A tooth never takes less")}),
        number("largest_chip_mm", &LevelFeed::largestChip, 0.0001, 5.0,
               {BURIN_TEXT("EditParameterTexts", "Largest chip"),
                BURIN_TEXT("EditParameterTexts", "A tooth never takes more")}),
        number("least_change", &LevelFeed::leastChange, 0.0, 1.0,
               {BURIN_TEXT("EditParameterTexts", "Least change"),
                BURIN_TEXT("EditParameterTexts", "Change of the feed; smaller changes are left out")}),
        number("sampling_mm", &LevelFeed::sampling, 0.05, 10.0,
               {BURIN_TEXT("EditParameterTexts", "Sampling"),
                BURIN_TEXT("EditParameterTexts", "Distance between the points at which moves are evaluated")})};
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
                          {BURIN_TEXT("EditParameterTexts", "Factor"),
                           BURIN_TEXT("EditParameterTexts", "Feeds inside the area are multiplied by this")})});
};
template <>
struct EditRow<ScaleFeed> {
    static constexpr EditTraits traits{.id = "stroke-feed",
                                       .title = BURIN_TEXT("Edit", "Feed of strokes"),
                                       .group = EditGroup::feeds,
                                       .step = EditStep::tuning};
    static constexpr std::tuple fields{
        stretch("stretch", &ScaleFeed::stretch, strokesToEdit),
        number("factor", &ScaleFeed::factor, 0.05, 5.0,
               {BURIN_TEXT("EditParameterTexts", "Factor"),
                BURIN_TEXT("EditParameterTexts", "Feeds of these strokes are multiplied by this")})};
};
template <>
struct EditRow<SpindleAndCoolant> {
    static constexpr EditTraits traits{.id = "section",
                                       .title = BURIN_TEXT("Edit", "Spindle and coolant"),
                                       .group = EditGroup::feeds,
                                       .step = EditStep::tuning};
    static constexpr std::array<EditChoice, 4> coolings{{{"kept", BURIN_TEXT("EditParameterTexts", "unchanged")},
                                                         {"off", BURIN_TEXT("EditParameterTexts", "off")},
                                                         {"mist", BURIN_TEXT("EditParameterTexts", "mist (M7)")},
                                                         {"flood", BURIN_TEXT("EditParameterTexts", "flood (M8)")}}};
    static constexpr std::tuple fields{
        stretch("stretch", &SpindleAndCoolant::stretch, strokesToEdit),
        number("speed_rpm", &SpindleAndCoolant::speed, 0.0, machine_range::spindleSpeed.high,
               {BURIN_TEXT("EditParameterTexts", "Spindle speed"),
                BURIN_TEXT("EditParameterTexts", "Of these strokes; feeds stay as they are. 0: unchanged")}),
        number("speed_factor", &SpindleAndCoolant::factor, 0.05, 5.0,
               {BURIN_TEXT("EditParameterTexts", "Share of the speed"),
                BURIN_TEXT("EditParameterTexts", "Spindle speeds of these strokes are multiplied by this")}),
        choice("coolant", &SpindleAndCoolant::cooling, coolings,
               {BURIN_TEXT("EditParameterTexts", "Coolant"),
                BURIN_TEXT("EditParameterTexts", "Of these strokes, if the machine has it")})};
};

} // namespace burin
