// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/base/text.h"
#include "core/path/curve_edits.h"
#include "core/path/machine_edits.h"
#include "core/path/recording_edits.h"
#include "core/path/surface_edits.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace burin {

/// All kinds of edits, a std::variant. What is known of each stands in one row of edit_rows.h.
using EditParameters = VariantOf<RecordingEdits, SurfaceEdits, CurveEdits, MachineEdits>::Type;

/// One entry of a path's history.
struct Edit {
    EditParameters parameters;
    bool enabled = true;
};
TextId titleOf(const EditParameters& parameters);
/// Stable id of an edit's kind: "drop-air-cuts", "smooth", … and back.
std::string_view idOf(const EditParameters& parameters);
/// {"edit": id, "enabled": true, parameters with their unit}; what is left out has its first value, or means what it
/// did before there was that parameter; unknown keys are errors. Errors: argumentInvalid (subject: the key),
/// nameUnknown (the id).
Result<Edit> editFromJson(std::string_view text);
std::string toJson(const Edit& edit);
/// Errors: argumentInvalid (subject: the key, place: its value, detail: what is allowed).
Result<void> validate(const Edit& edit);

/// What one parameter of an edit is: a number, a switch, one of some names, a place or vector, places, a moment or a
/// stretch of the hand.
using EditValue =
    std::variant<double, bool, std::string_view, glm::dvec3, std::vector<glm::dvec3>, Moment, SourceStretch>;

/// What the user reads of a parameter.
struct FieldWords {
    TextId label, toolTip;
};

/// One of the names that a parameter may be.
struct EditChoice {
    std::string_view name; ///< as in the edit's JSON
    TextId words;
};

/// One parameter of an edit, with what it may be. What files, panels and validation know of it.
struct EditField {
    std::string_view key; ///< as in the edit's JSON, its unit at the end: "tolerance_mm"
    FieldWords words;
    EditValue value;
    double low = 0.0, high = 0.0;          ///< of a number, of each coordinate, of a count of places
    bool whole = false;                    ///< a number that counts
    std::span<const EditChoice> choices{}; ///< of a name
};
/// Every parameter of an edit, in order; none for a kind that has none.
std::vector<EditField> fieldsOf(const EditParameters& parameters);
/// @param key of one of the edit's parameters; @param value of its kind, not checked here: see `validate`
void setField(EditParameters& parameters, std::string_view key, const EditValue& value);

/// What replaces an edit of an earlier version, and does what was meant by it: smoothing in time becomes smoothing of
/// the shape, its cut-off the wavelength that a hand of 15 mm/s gives that frequency; leads go by the recording.
/// Nothing: the edit is the newest.
std::optional<Edit> updated(const Edit& edit);

/// The edits of the main job, in the order that keeps their guarantees.
std::vector<Edit> standardEdits();
/// Those of a path that is computed: the same without what makes up for a hand.
std::vector<Edit> computedEdits();
/// Of a path that is made of a program: its moves and feeds stay as they are, arcs are found again, rapids are links.
std::vector<Edit> programEdits();
/// One of each kind, with its first values, in the order in which they may follow each other.
std::vector<Edit> everyEdit();

} // namespace burin
