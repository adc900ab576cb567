// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_field.h"
#include "core/path/edit_step.h"

namespace burin {

/// The row of a kind of edit in the table of edits (edit_rows.h): `traits`, and `fields`, a tuple of objects made by
/// the functions of edit_field.h.
template <class T>
struct EditRow;

// Texts of parameters that several kinds have.
inline constexpr FieldLabels strokesToEdit{
    BURIN_TEXT("EditParameterLabels", "Applies to"),
    BURIN_TEXT("EditParameterLabels", "Strokes to edit. Select them in the view first")};
inline constexpr FieldLabels recordingTolerance{
    BURIN_TEXT("EditParameterLabels", "Tolerance"),
    BURIN_TEXT("EditParameterLabels", "Largest deviation from the recording")};
inline constexpr FieldLabels cutOffFrequency{BURIN_TEXT("EditParameterLabels", "Cut-off frequency"),
                                             BURIN_TEXT("EditParameterLabels", "Tremor above it is removed")};
inline constexpr FieldLabels turnCentre{
    BURIN_TEXT("EditParameterLabels", "Centre"),
    BURIN_TEXT("EditParameterLabels", "Position of the vertical axis of rotation, from program zero")};
inline constexpr FieldLabels stockLeft{BURIN_TEXT("EditParameterLabels", "Allowance"),
                                       BURIN_TEXT("EditParameterLabels", "Stock left on the part")};

} // namespace burin
