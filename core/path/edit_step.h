// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/path/edit.h"

#include <cstdint>
#include <span>

namespace burin {

/// Edits that rely on one another come in these steps; within a step any order is allowed. Timing is lost by
/// simplification, straight moves by arc fitting, separate strokes by linking.
enum class EditStep : std::uint8_t {
    recording, ///< the recorded motion, tick by tick
    surface,   ///< kept out of the part, simplified
    curves,    ///< arcs instead of lines
    ends,      ///< lead-ins and lead-outs
    links,     ///< one path instead of strokes
    feed,      ///< feeds and spindle speed from the tables
    tuning,    ///< feeds that depend on the position
    axis       ///< the tool is tilted: edits before it rely on an upright one
};

/// The topics under which a user looks for edits.
enum class EditGroup : std::uint8_t {
    strokes,     ///< omitting, cutting and joining them
    arrangement, ///< their order, direction, position and number
    places,      ///< drawn by hand
    smoothing,   ///< smoother, or with fewer moves
    surface,     ///< relative to the part
    links,       ///< lead-ins, lead-outs, and links between strokes
    feeds
};

/// Properties of a kind of edit, besides its parameters.
struct EditTraits {
    std::string_view id;
    TextId title;
    EditGroup group = EditGroup::strokes;
    EditStep step = EditStep::recording;
    bool once = false;         ///< may occur only once in a path
    bool approximates = false; ///< its deviation is an error and counts in the error budget
    bool mayEnter = false;     ///< may lead the path into the part
    bool holdsOut = false;     ///< ensures the allowance, whatever came before
    bool superseded = false;   ///< an earlier version, kept for the paths that contain it: see `updated`
};
const EditTraits& traitsOf(const EditParameters& parameters);

/// Whether edits may follow each other in this order: steps ascend, a kind that may occur only once does, and edits
/// that may lead the path into the part are followed by one that keeps it out before any edit that relies on it (arcs,
/// links).
/// Errors: editMisplaced, editRepeated, editUnguarded; those of validate.
Result<void> checkOrder(std::span<const Edit> edits);

} // namespace burin
