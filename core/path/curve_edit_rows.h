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
               {BURIN_TEXT("EditParameterTexts", "Tolerance"),
                BURIN_TEXT("EditParameterTexts", "Largest deviation of an arc from the path")}),
        number("largest_sweep_rad", &FitArcs::largestSweep, 0.1, pi,
               {BURIN_TEXT("EditParameterTexts", "Largest sweep"),
                BURIN_TEXT("EditParameterTexts", "Arcs of a larger angle are split")}),
        number("smallest_radius_mm", &FitArcs::smallestRadius, 0.01, 100.0,
               {BURIN_TEXT("EditParameterTexts", "Smallest radius"),
                BURIN_TEXT("EditParameterTexts", "Curves with a smaller radius stay straight moves")}),
        number("largest_radius_mm", &FitArcs::largestRadius, 0.1, 10000.0,
               {BURIN_TEXT("EditParameterTexts", "Largest radius"),
                BURIN_TEXT("EditParameterTexts", "Curves with a larger radius stay straight moves")}),
        number(
            "radius_mismatch_mm", &FitArcs::radiusMismatch, 0.0001, 0.1,
            {BURIN_TEXT("EditParameterTexts", "Radius mismatch"),
             BURIN_TEXT("EditParameterTexts", "How far the radii at both ends may differ once values are rounded")})};
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
               {BURIN_TEXT("EditParameterTexts", "Tolerance"),
                BURIN_TEXT("EditParameterTexts", "Largest deviation of a rounded corner from the sharp one")}),
        number("smallest_turn_rad", &RoundCorners::smallestTurn, 0.001, 3.0,
               {BURIN_TEXT("EditParameterTexts", "Smallest turn"),
                BURIN_TEXT("EditParameterTexts", "Corners with a smaller angle are kept")})};
};
inline constexpr FieldWords leadForm{BURIN_TEXT("EditParameterTexts", "Form"),
                                     BURIN_TEXT("EditParameterTexts", "Motion onto the stroke, or away from it")};
inline constexpr FieldWords leadSide{
    BURIN_TEXT("EditParameterTexts", "Direction by"),
    BURIN_TEXT("EditParameterTexts", "By the recording, leads keep their side when other edits change")};
inline constexpr std::array<EditChoice, 2> leadDirections{
    {{"first-move", BURIN_TEXT("EditParameterTexts", "the first move")},
     {"recording", BURIN_TEXT("EditParameterTexts", "the recording")}}};
template <>
struct EditRow<LeadIn> {
    static constexpr EditTraits traits{
        .id = "lead-in", .title = BURIN_TEXT("Edit", "Lead in"), .group = EditGroup::links, .step = EditStep::ends};
    static constexpr std::array<EditChoice, 4> forms{{{"line", BURIN_TEXT("EditParameterTexts", "a straight line")},
                                                      {"arc", BURIN_TEXT("EditParameterTexts", "an arc")},
                                                      {"ramp", BURIN_TEXT("EditParameterTexts", "a ramp")},
                                                      {"helix", BURIN_TEXT("EditParameterTexts", "a helix")}}};
    static constexpr std::tuple fields{
        stretch("stretch", &LeadIn::stretch,
                {BURIN_TEXT("EditParameterTexts", "Applies to"),
                 BURIN_TEXT("EditParameterTexts", "Strokes that get a lead-in. Select them in the view first")}),
        choice("form", &LeadIn::form, forms, leadForm),
        number("size_mm", &LeadIn::size, 0.05, 1000.0,
               {BURIN_TEXT("EditParameterTexts", "Size"),
                BURIN_TEXT("EditParameterTexts", "Length of a line or ramp, radius of an arc or helix")}),
        number("height_mm", &LeadIn::height, 0.01, 1000.0,
               {BURIN_TEXT("EditParameterTexts", "Height"),
                BURIN_TEXT("EditParameterTexts", "Height of a ramp or helix")}),
        number("angle_rad", &LeadIn::angle, 0.002, 1.2,
               {BURIN_TEXT("EditParameterTexts", "Angle"),
                BURIN_TEXT("EditParameterTexts", "Largest descent angle of a helix")}),
        choice("direction", &LeadIn::direction, leadDirections, leadSide)};
};
template <>
struct EditRow<LeadOut> {
    static constexpr EditTraits traits{
        .id = "lead-out", .title = BURIN_TEXT("Edit", "Lead out"), .group = EditGroup::links, .step = EditStep::ends};
    static constexpr std::array<EditChoice, 2> forms{{{"line", BURIN_TEXT("EditParameterTexts", "a straight line")},
                                                      {"arc", BURIN_TEXT("EditParameterTexts", "an arc")}}};
    static constexpr std::tuple fields{stretch("stretch", &LeadOut::stretch, strokesToEdit),
                                       choice("form", &LeadOut::form, forms, leadForm),
                                       number("size_mm", &LeadOut::size, 0.05, 1000.0,
                                              {BURIN_TEXT("EditParameterTexts", "Size"),
                                               BURIN_TEXT("EditParameterTexts", "Length of a line, radius of an arc")}),
                                       choice("direction", &LeadOut::direction, leadDirections, leadSide)};
};

} // namespace burin
