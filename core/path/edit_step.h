// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/path/edit.h"

#include <cstdint>
#include <span>

namespace burin {

/// Edits that rely on one another come in these steps; within a step any order goes. Time is lost with thinning,
/// straight moves with arcs, strokes with linking.
enum class EditStep : std::uint8_t {
    recording, ///< what the hand did, tick by tick
    surface,   ///< held against the part, thinned
    curves,    ///< arcs instead of lines
    ends,      ///< ways into strokes and out of them
    links,     ///< one path instead of strokes
    feed,      ///< feeds and speed by the tables
    tuning     ///< feeds that depend on the place
};

/// What edits are about, as a user looks for them.
enum class EditGroup : std::uint8_t {
    strokes,     ///< leaving some out, cutting and joining them
    arrangement, ///< their order, direction, place and number
    places,      ///< drawn by hand
    smoothing,   ///< smoother, or of fewer moves
    surface,     ///< against the part
    links,       ///< ways into strokes, out of them and between them
    feeds
};

/// What is known of a kind of edit, besides its parameters.
struct EditTraits {
    std::string_view id;
    TextId title;
    EditGroup group = EditGroup::strokes;
    EditStep step = EditStep::recording;
    bool once = false;         ///< no second one in a path
    bool approximates = false; ///< what it moves the path by is an error, and counts in the budget
    bool mayEnter = false;     ///< may lead the path into the part
    bool holdsOut = false;     ///< keeps the allowance, whatever was before
    bool superseded = false;   ///< an earlier version, kept for the paths that have it: see `updated`
};
const EditTraits& traitsOf(const EditParameters& parameters);

/// Whether edits may follow each other so: by their steps, none twice that goes only once, and those that may lead the
/// path into the part followed by one that holds it out before anything that relies on it (arcs, links).
/// Errors: editMisplaced, editRepeated, editUnguarded; those of validate.
Result<void> checkOrder(std::span<const Edit> edits);

} // namespace burin
