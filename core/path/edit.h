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

/// All kinds of edits, a std::variant. All facts about a kind are in one row of edit_rows.h.
using EditParameters = VariantOf<RecordingEdits, SurfaceEdits, CurveEdits, MachineEdits>::Type;

/// One entry of a path's history.
struct Edit {
    EditParameters parameters;
    bool enabled = true;
};
TextId titleOf(const EditParameters& parameters);
/// Stable id of an edit's kind: "drop-air-cuts", "smooth", … and back.
std::string_view idOf(const EditParameters& parameters);
/// {"edit": id, "enabled": true, parameters with their unit}. A missing key has its first value, or means what the edit
/// did before the parameter existed; unknown keys are errors. Errors: argumentInvalid (subject: the key),
/// nameUnknown (the id).
Result<Edit> editFromJson(std::string_view text);
std::string toJson(const Edit& edit);
/// Errors: argumentInvalid (subject: the key, place: its value, detail: what is allowed).
Result<void> validate(const Edit& edit);

/// The value of one parameter of an edit: a number, a switch, one of several names, a point or vector, points, a moment
/// or an interval of a source.
using EditValue =
    std::variant<double, bool, std::string_view, glm::dvec3, std::vector<glm::dvec3>, Moment, SourceInterval>;

/// The texts that the user reads about a parameter.
struct FieldLabels {
    TextId label, toolTip;
};

/// One of the names that a parameter may have as its value.
struct EditChoice {
    std::string_view name; ///< as in the edit's JSON
    TextId words;
};

/// One parameter of an edit, with its allowed values; used by files, panels and validation.
struct EditField {
    std::string_view key; ///< as in the edit's JSON, its unit at the end: "tolerance_mm"
    FieldLabels words;
    EditValue value;
    double low = 0.0, high = 0.0;          ///< limits of a number, of each coordinate, of a count of points
    bool whole = false;                    ///< an integral number
    std::span<const EditChoice> choices{}; ///< of a name
};
/// Every parameter of an edit, in order; empty for a kind that has none.
std::vector<EditField> fieldsOf(const EditParameters& parameters);
/// @param key of one of the edit's parameters; @param value of its kind, not checked here: see `validate`
void setField(EditParameters& parameters, std::string_view key, const EditValue& value);

/// The replacement for an edit of an earlier version, with the same purpose: smoothing in time becomes smoothing of the
/// shape, its cut-off the wavelength that a hand moving at 15 mm/s gives that frequency; leads take their direction
/// from the recording. Empty if the edit is up to date.
std::optional<Edit> updated(const Edit& edit);

/// The edits of the main job, in the order that keeps their guarantees.
std::vector<Edit> standardEdits();
/// The edits of a computed path: the same without those that compensate for a hand.
std::vector<Edit> computedEdits();
/// The edits of a path made from a program: its moves and feeds stay as they are, arcs are detected again, rapids
/// become links.
std::vector<Edit> programEdits();
/// Whether an edit suits a tool that doesn't turn: it does not tilt it, sets no feeds, spindle or coolant, as the
/// tables are those of teeth, and links at the safe height, straight down.
bool suitsFixedTool(const EditParameters& parameters);
/// Returns those of the edits that suit such a tool; links are adjusted.
std::vector<Edit> forFixedTool(std::vector<Edit> edits);
/// One edit of each kind, with its first values, in the order in which they may follow each other.
std::vector<Edit> everyEdit();

} // namespace burin
