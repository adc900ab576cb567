// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_row.h"

#include <tuple>

/// Rows of the table of edits (edit_rows.h).
namespace burin {

template <>
struct EditRow<HoldOut> {
    static constexpr EditTraits traits{.id = "hold-out",
                                       .title = BURIN_TEXT("Edit", "Keep out of the part"),
                                       .group = EditGroup::surface,
                                       .step = EditStep::surface,
                                       .approximates = true,
                                       .holdsOut = true};
    static constexpr std::tuple fields{
        number("clearance_mm", &HoldOut::clearance, 0.001, 10.0,
               {BURIN_TEXT("EditParameterLabels", "Clearance"),
                BURIN_TEXT("EditParameterLabels", "Distance from the part, in addition to the allowance")}),
        number("sampling_mm", &HoldOut::sampling, 0.005, 1.0,
               {BURIN_TEXT("EditParameterLabels", "Sampling"),
                BURIN_TEXT("EditParameterLabels",
                           "Distance between the points at which the path is kept out of the part")})};
};
template <>
struct EditRow<LayOnPart> {
    static constexpr EditTraits traits{.id = "project",
                                       .title = BURIN_TEXT("Edit", "Project onto the part"),
                                       .group = EditGroup::surface,
                                       .step = EditStep::surface,
                                       .holdsOut = true};
    static constexpr std::array<EditChoice, 2> ways{
        {{"axis", BURIN_TEXT("EditParameterLabels", "the tool's axis")},
         {"normal", BURIN_TEXT("EditParameterLabels", "the part's normal")}}};
    static constexpr std::tuple fields{
        number("allowance_mm", &LayOnPart::allowance, 0.0, 100.0, stockLeft),
        number("sampling_mm", &LayOnPart::sampling, 0.01, 1.0,
               {BURIN_TEXT("EditParameterLabels", "Sampling"),
                BURIN_TEXT("EditParameterLabels", "Distance between the points that are projected onto the part")}),
        choice("along", &LayOnPart::along, ways,
               {BURIN_TEXT("EditParameterLabels", "Along"),
                BURIN_TEXT("EditParameterLabels", "Down the tool's axis, or along the part's normal")})};
};
template <>
struct EditRow<Offset> {
    static constexpr EditTraits traits{.id = "offset",
                                       .title = BURIN_TEXT("Edit", "Offset"),
                                       .group = EditGroup::surface,
                                       .step = EditStep::surface,
                                       .mayEnter = true};
    static constexpr std::tuple fields{
        interval("stretch", &Offset::interval, strokesToEdit),
        number("distance_mm", &Offset::distance, -1000.0, 1000.0,
               {BURIN_TEXT("EditParameterLabels", "Distance"),
                BURIN_TEXT("EditParameterLabels", "To the left of the motion; negative to the right")})};
};
template <>
struct EditRow<StepOverRows> {
    static constexpr EditTraits traits{.id = "guide-rows",
                                       .title = BURIN_TEXT("Edit", "Rows along a guide"),
                                       .group = EditGroup::surface,
                                       .step = EditStep::surface,
                                       .holdsOut = true};
    static constexpr std::tuple fields{
        interval("stretch", &StepOverRows::interval, strokesToEdit),
        places("guide_mm", &StepOverRows::guide, 2.0,
               {BURIN_TEXT("EditParameterLabels", "Guide"),
                BURIN_TEXT("EditParameterLabels", "Points of a drawn guide; none: the selected strokes")}),
        number("step_over_mm", &StepOverRows::stepOver, 0.005, 100.0,
               {BURIN_TEXT("EditParameterLabels", "Step-over"),
                BURIN_TEXT("EditParameterLabels", "Between rows, seen from above")}),
        count("left", &StepOverRows::left, 0.0, 1000.0,
              {BURIN_TEXT("EditParameterLabels", "Rows to the left"),
               BURIN_TEXT("EditParameterLabels", "Beside the guide, in its direction")}),
        count("right", &StepOverRows::right, 0.0, 1000.0,
              {BURIN_TEXT("EditParameterLabels", "Rows to the right"),
               BURIN_TEXT("EditParameterLabels", "Beside the guide, in its direction")}),
        number("allowance_mm", &StepOverRows::allowance, 0.0, 100.0, stockLeft)};
};
template <>
struct EditRow<Simplify> {
    static constexpr EditTraits traits{.id = "simplify",
                                       .title = BURIN_TEXT("Edit", "Simplify"),
                                       .group = EditGroup::smoothing,
                                       .step = EditStep::surface,
                                       .approximates = true};
    static constexpr std::tuple fields{
        number("tolerance_mm", &Simplify::tolerance, 0.0, 10.0,
               {BURIN_TEXT("EditParameterLabels", "Tolerance"),
                BURIN_TEXT("EditParameterLabels", "Largest deviation of the points that are left out")})};
};

} // namespace burin
