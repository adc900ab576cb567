// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/path/edit_row.h"

#include <tuple>

/// Rows of the table of edits (edit_rows.h).
namespace burin {

template <>
struct EditRow<FitArcs> {
    static constexpr EditTraits traits{.id = "fit-arcs",
                                       .title = BURIN_TEXT("Edit", "Fit arcs"),
                                       .group = EditGroup::smoothing,
                                       .step = EditStep::curves,
                                       .approximates = true};
    static constexpr std::tuple fields{
        number("tolerance_mm", &FitArcs::tolerance, 0.0002, 1.0,
               {BURIN_TEXT("EditParameterLabels", "Tolerance"),
                BURIN_TEXT("EditParameterLabels", "Largest deviation of an arc from the path")}),
        number("largest_sweep_rad", &FitArcs::largestSweep, 0.1, pi,
               {BURIN_TEXT("EditParameterLabels", "Largest sweep"),
                BURIN_TEXT("EditParameterLabels", "Arcs of a larger angle are split")}),
        number("smallest_radius_mm", &FitArcs::smallestRadius, 0.01, 100.0,
               {BURIN_TEXT("EditParameterLabels", "Smallest radius"),
                BURIN_TEXT("EditParameterLabels", "Curves with a smaller radius stay straight moves")}),
        number("largest_radius_mm", &FitArcs::largestRadius, 0.1, 10000.0,
               {BURIN_TEXT("EditParameterLabels", "Largest radius"),
                BURIN_TEXT("EditParameterLabels", "Curves with a larger radius stay straight moves")}),
        number(
            "radius_mismatch_mm", &FitArcs::radiusMismatch, 0.0001, 0.1,
            {BURIN_TEXT("EditParameterLabels", "Radius mismatch"),
             BURIN_TEXT("EditParameterLabels", "How far the radii at both ends may differ once values are rounded")})};
};
template <>
struct EditRow<RoundCorners> {
    static constexpr EditTraits traits{.id = "round-corners",
                                       .title = BURIN_TEXT("Edit", "Round corners"),
                                       .group = EditGroup::smoothing,
                                       .step = EditStep::curves,
                                       .approximates = true};
    static constexpr std::tuple fields{
        number("tolerance_mm", &RoundCorners::tolerance, 0.001, 10.0,
               {BURIN_TEXT("EditParameterLabels", "Tolerance"),
                BURIN_TEXT("EditParameterLabels", "Largest deviation of a rounded corner from the sharp one")}),
        number("smallest_turn_rad", &RoundCorners::smallestTurn, 0.001, 3.0,
               {BURIN_TEXT("EditParameterLabels", "Smallest turn"),
                BURIN_TEXT("EditParameterLabels", "Corners with a smaller angle are kept")})};
};
inline constexpr FieldLabels leadForm{BURIN_TEXT("EditParameterLabels", "Form"),
                                      BURIN_TEXT("EditParameterLabels", "Motion onto the stroke, or away from it")};
inline constexpr FieldLabels leadSide{
    BURIN_TEXT("EditParameterLabels", "Direction by"),
    BURIN_TEXT("EditParameterLabels", "By the recording, leads keep their side when other edits change")};
inline constexpr std::array<EditChoice, 2> leadDirections{
    {{"first-move", BURIN_TEXT("EditParameterLabels", "the first move")},
     {"recording", BURIN_TEXT("EditParameterLabels", "the recording")}}};
template <>
struct EditRow<LeadIn> {
    static constexpr EditTraits traits{
        .id = "lead-in", .title = BURIN_TEXT("Edit", "Lead in"), .group = EditGroup::links, .step = EditStep::ends};
    static constexpr std::array<EditChoice, 4> forms{{{"line", BURIN_TEXT("EditParameterLabels", "a straight line")},
                                                      {"arc", BURIN_TEXT("EditParameterLabels", "an arc")},
                                                      {"ramp", BURIN_TEXT("EditParameterLabels", "a ramp")},
                                                      {"helix", BURIN_TEXT("EditParameterLabels", "a helix")}}};
    static constexpr std::tuple fields{
        interval("stretch", &LeadIn::interval,
                 {BURIN_TEXT("EditParameterLabels", "Applies to"),
                  BURIN_TEXT("EditParameterLabels", "Strokes that get a lead-in. Select them in the view first")}),
        choice("form", &LeadIn::form, forms, leadForm),
        number("size_mm", &LeadIn::size, 0.05, 1000.0,
               {BURIN_TEXT("EditParameterLabels", "Size"),
                BURIN_TEXT("EditParameterLabels", "Length of a line or ramp, radius of an arc or helix")}),
        number("height_mm", &LeadIn::height, 0.01, 1000.0,
               {BURIN_TEXT("EditParameterLabels", "Height"),
                BURIN_TEXT("EditParameterLabels", "Height of a ramp or helix")}),
        number("angle_rad", &LeadIn::angle, 0.002, 1.2,
               {BURIN_TEXT("EditParameterLabels", "Angle"),
                BURIN_TEXT("EditParameterLabels", "Largest descent angle of a helix")}),
        choice("direction", &LeadIn::direction, leadDirections, leadSide)};
};
template <>
struct EditRow<LeadOut> {
    static constexpr EditTraits traits{
        .id = "lead-out", .title = BURIN_TEXT("Edit", "Lead out"), .group = EditGroup::links, .step = EditStep::ends};
    static constexpr std::array<EditChoice, 2> forms{{{"line", BURIN_TEXT("EditParameterLabels", "a straight line")},
                                                      {"arc", BURIN_TEXT("EditParameterLabels", "an arc")}}};
    static constexpr std::tuple fields{
        interval("stretch", &LeadOut::interval, strokesToEdit), choice("form", &LeadOut::form, forms, leadForm),
        number("size_mm", &LeadOut::size, 0.05, 1000.0,
               {BURIN_TEXT("EditParameterLabels", "Size"),
                BURIN_TEXT("EditParameterLabels", "Length of a line, radius of an arc")}),
        choice("direction", &LeadOut::direction, leadDirections, leadSide)};
};

} // namespace burin
