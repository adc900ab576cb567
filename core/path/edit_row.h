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
inline constexpr FieldWords strokesToEdit{
    BURIN_TEXT("EditParameterTexts", "Applies to"),
    BURIN_TEXT("EditParameterTexts", "Strokes to edit. Select them in the view first")};
inline constexpr FieldWords recordingTolerance{
    BURIN_TEXT("EditParameterTexts", "Tolerance"),
    BURIN_TEXT("EditParameterTexts", "Largest deviation from the recording")};
inline constexpr FieldWords cutOffFrequency{BURIN_TEXT("EditParameterTexts", "Cut-off frequency"),
                                            BURIN_TEXT("EditParameterTexts", "Tremor above it is removed")};
inline constexpr FieldWords turnCentre{
    BURIN_TEXT("EditParameterTexts", "Centre"),
    BURIN_TEXT("EditParameterTexts", "Position of the vertical axis of rotation, from program zero")};
inline constexpr FieldWords stockLeft{BURIN_TEXT("EditParameterTexts", "Allowance"),
                                      BURIN_TEXT("EditParameterTexts", "Stock left on the part")};

} // namespace burin
