// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/problem.h"

#include <array>

namespace burin {
namespace {

struct Wording {
    std::string_view id, text;
};

constexpr std::array<Wording, static_cast<std::size_t>(ProgramProblem::count)> wordings{{
    {"line_too_long", "the control does not read so long a line"},
    {"character_not_allowed", "character is not allowed"},
    {"comment_not_closed", "comment is not closed"},
    {"comment_nested", "comment inside a comment"},
    {"percent_not_alone", "% has to stand alone"},
    {"percent_not_read", "the control does not read %"},
    {"line_number_not_first", "line number has to stand first"},
    {"word_not_read", "the control does not read this word"},
    {"word_twice", "word stands twice"},
    {"word_without_use", "no other word of the block uses this one"},
    {"number_missing", "word without a number"},
    {"number_out_of_range", "number is out of range"},
    {"number_not_whole", "number is not whole"},
    {"number_negative", "negative number"},
    {"point_missing", "decimal point is missing: the control would take the number for its smallest steps"},
    {"code_not_read", "code is not read"},
    {"codes_of_one_group", "two words of one modal group"},
    {"code_reads_axes", "two codes of the block read its axis words"},
    {"expression_not_read", "the control reads no parameters or expressions"},
    {"expression_invalid", "expression is not complete"},
    {"expression_undefined", "expression has no value"},
    {"parameter_not_allowed", "there is no such parameter, or it can't be set"},
    {"parameter_unknown", "the program does not say what the parameter holds"},
    {"behind_end", "words behind the program's end"},
    {"too_many_moves", "the program makes more moves than are kept of it (20 million)"},
    {"cutter_compensation", "cutter radius compensation is not read: program the centre of the tool"},
    {"subprogram", "subprograms and flow control are not read"},
    {"tool_not_selected", "tool change without a tool"},
    {"work_offset_missing", "work offset is missing"},
    {"length_offset_missing", "length offset is missing"},
    {"units_change_beside_feed", "feed beside a change of units"},
    {"feed_missing", "feed is missing"},
    {"feed_missing_inverse_time", "each move needs its F while G93 is in force"},
    {"spindle_stands_still", "feed per revolution with a spindle that stands still"},
    {"dwell_missing", "dwell without its time"},
    {"dwell_moves", "dwell and motion in one block"},
    {"place_unknown", "the program does not say where this begins"},
    {"axis_missing", "axis word is missing"},
    {"axis_without_motion", "axis word without a motion in force"},
    {"machine_frame_motion", "G53 needs G0 or G1"},
    {"arc_centre_missing", "arc without its centre or radius"},
    {"arc_offset_across", "arc offset across the arc's plane"},
    {"arc_offset_without_arc", "arc offset without an arc"},
    {"arc_radius_zero", "arc of radius zero"},
    {"arc_radius_differs", "radius at the end of the arc differs from the radius at its start"},
    {"arc_radius_too_small", "radius is too small to reach the end of the arc"},
    {"arc_radius_full_turn", "arc by radius that ends where it begins"},
    {"arc_radius_and_centre", "arc by radius and by centre"},
    {"arc_turns", "number of turns has to be whole and above 0"},
    {"cycle_feed_mode", "canned cycle with inverse time feed"},
    {"cycle_height_missing", "canned cycle without R"},
    {"cycle_depth_missing", "canned cycle without its depth"},
    {"cycle_height_below_depth", "R of the canned cycle lies below its depth"},
    {"cycle_word_missing", "canned cycle lacks a word"},
    {"cycle_step", "Q has to be above 0, and large enough for the depth"},
    {"cycle_spindle", "canned cycle with a spindle that stands still, or turns the other way"},
    {"cycle_repeats", "number of repeats has to be whole and from 1 to 10000"},
    {"end_missing", "program end is missing"},
    {"plunge_without_centre", "the cutter does not cut at its centre and is fed straight down"},
    {"feed_above_machine", "feed is above the machine's"},
    {"spindle_beyond_machine", "spindle speed is beyond the machine's"},
    {"arc_mode_missing", "how arc centres are read is a setting of this control: state G91.1"},
    {"units_missing", "the program does not state its units"},
    {"feed_point_missing", "feed without a decimal point"},
}};
// A problem that was added without its wording has an empty one.
static_assert(!wordings.back().id.empty());

} // namespace

std::string_view idOf(ProgramProblem problem) noexcept {
    return wordings[static_cast<std::size_t>(problem)].id;
}

std::string_view wordingOf(ProgramProblem problem) noexcept {
    return wordings[static_cast<std::size_t>(problem)].text;
}

} // namespace burin
