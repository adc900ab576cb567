// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/problem.h"

#include "core/base/csv.h"

#include <algorithm>
#include <array>

namespace burin {
namespace {

struct Wording {
    std::string_view id;
    TextId text;
};

constexpr std::array<Wording, static_cast<std::size_t>(ProgramProblem::count)> wordings{{
    {"line_too_long", BURIN_TEXT("ProgramProblem", "the line is too long for the control")},
    {"character_not_allowed", BURIN_TEXT("ProgramProblem", "character is not allowed")},
    {"comment_not_closed", BURIN_TEXT("ProgramProblem", "comment is not closed")},
    {"comment_nested", BURIN_TEXT("ProgramProblem", "comment inside a comment")},
    {"percent_not_alone", BURIN_TEXT("ProgramProblem", "% has to be alone on its line")},
    {"percent_not_read", BURIN_TEXT("ProgramProblem", "the control does not read %")},
    {"percent_misplaced",
     BURIN_TEXT("ProgramProblem",
                "the control accepts % only in the first line, and after the program only if the first line has one")},
    {"line_number_not_first", BURIN_TEXT("ProgramProblem", "line number has to come first")},
    {"word_not_read", BURIN_TEXT("ProgramProblem", "the control does not read this word")},
    {"word_twice", BURIN_TEXT("ProgramProblem", "word is repeated")},
    {"word_without_use", BURIN_TEXT("ProgramProblem", "no other word of the block uses this one")},
    {"number_missing", BURIN_TEXT("ProgramProblem", "word without a number")},
    {"number_out_of_range", BURIN_TEXT("ProgramProblem", "number is out of range")},
    {"number_not_whole", BURIN_TEXT("ProgramProblem", "number is not an integer")},
    {"number_negative", BURIN_TEXT("ProgramProblem", "negative number")},
    {"point_missing", BURIN_TEXT("ProgramProblem",
                                 "decimal point is missing: the control would take the number for its smallest steps")},
    {"code_not_read", BURIN_TEXT("ProgramProblem", "code is not supported")},
    {"codes_of_one_group", BURIN_TEXT("ProgramProblem", "two words of one modal group")},
    {"too_many_m_words", BURIN_TEXT("ProgramProblem", "more M words than the control allows in a block")},
    {"code_reads_axes", BURIN_TEXT("ProgramProblem", "two codes of the block use its axis words")},
    {"expression_not_read", BURIN_TEXT("ProgramProblem", "the control reads no parameters or expressions")},
    {"expression_invalid", BURIN_TEXT("ProgramProblem", "expression is not complete")},
    {"expression_undefined", BURIN_TEXT("ProgramProblem", "expression has no value")},
    {"parameter_not_allowed", BURIN_TEXT("ProgramProblem", "there is no such parameter, or it can't be set")},
    {"parameter_unknown", BURIN_TEXT("ProgramProblem", "the value of the parameter is unknown")},
    {"too_many_moves", BURIN_TEXT("ProgramProblem", "the program has more moves than can be kept (20 million)")},
    {"cutter_compensation",
     BURIN_TEXT("ProgramProblem", "cutter radius compensation is not supported: program the centre of the tool")},
    {"subprogram", BURIN_TEXT("ProgramProblem", "subprograms and flow control are not supported")},
    {"tool_not_selected", BURIN_TEXT("ProgramProblem", "tool change without a tool")},
    {"work_offset_missing", BURIN_TEXT("ProgramProblem", "work offset is missing")},
    {"length_offset_missing", BURIN_TEXT("ProgramProblem", "length offset is missing")},
    {"units_change_beside_feed", BURIN_TEXT("ProgramProblem", "feed together with a change of units")},
    {"feed_missing", BURIN_TEXT("ProgramProblem", "feed is missing")},
    {"feed_missing_inverse_time", BURIN_TEXT("ProgramProblem", "each move needs its F while G93 is in force")},
    {"spindle_stands_still", BURIN_TEXT("ProgramProblem", "feed per revolution with the spindle stopped")},
    {"dwell_missing", BURIN_TEXT("ProgramProblem", "dwell without its time")},
    {"dwell_moves", BURIN_TEXT("ProgramProblem", "dwell and motion in one block")},
    {"place_unknown", BURIN_TEXT("ProgramProblem", "the start position is unknown")},
    {"axis_missing", BURIN_TEXT("ProgramProblem", "axis word is missing")},
    {"axis_without_motion", BURIN_TEXT("ProgramProblem", "axis word without a motion in force")},
    {"machine_frame_motion", BURIN_TEXT("ProgramProblem", "G53 needs G0 or G1")},
    {"arc_centre_missing", BURIN_TEXT("ProgramProblem", "arc without its centre or radius")},
    {"arc_offset_across", BURIN_TEXT("ProgramProblem", "arc offset perpendicular to the arc's plane")},
    {"arc_offset_without_arc", BURIN_TEXT("ProgramProblem", "arc offset without an arc")},
    {"arc_radius_zero", BURIN_TEXT("ProgramProblem", "arc of radius zero")},
    {"arc_radius_differs",
     BURIN_TEXT("ProgramProblem", "radius at the end of the arc differs from the radius at its start")},
    {"arc_radius_too_small", BURIN_TEXT("ProgramProblem", "radius is too small to reach the end of the arc")},
    {"arc_radius_full_turn", BURIN_TEXT("ProgramProblem", "arc by radius that ends where it begins")},
    {"arc_radius_and_centre", BURIN_TEXT("ProgramProblem", "arc by radius and by centre")},
    {"arc_turns", BURIN_TEXT("ProgramProblem", "number of turns has to be an integer above 0")},
    {"cycle_feed_mode", BURIN_TEXT("ProgramProblem", "canned cycle with inverse time feed")},
    {"cycle_height_missing", BURIN_TEXT("ProgramProblem", "canned cycle without R")},
    {"cycle_depth_missing", BURIN_TEXT("ProgramProblem", "canned cycle without its depth")},
    {"cycle_height_below_depth", BURIN_TEXT("ProgramProblem", "R of the canned cycle lies below its depth")},
    {"cycle_word_missing", BURIN_TEXT("ProgramProblem", "canned cycle lacks a word")},
    {"cycle_step", BURIN_TEXT("ProgramProblem", "Q has to be above 0, and large enough for the depth")},
    {"cycle_spindle",
     BURIN_TEXT("ProgramProblem", "canned cycle with the spindle stopped, or rotating in the wrong direction")},
    {"cycle_repeats", BURIN_TEXT("ProgramProblem", "number of repeats has to be an integer from 1 to 10000")},
    {"end_missing", BURIN_TEXT("ProgramProblem", "program end is missing")},
    {"feed_above_machine", BURIN_TEXT("ProgramProblem", "feed is above the machine's")},
    {"spindle_beyond_machine", BURIN_TEXT("ProgramProblem", "spindle speed is beyond the machine's")},
    {"arc_mode_missing",
     BURIN_TEXT("ProgramProblem", "whether arc centres are absolute is a setting of this control: state G91.1")},
    {"units_missing", BURIN_TEXT("ProgramProblem", "the program does not state its units")},
    {"feed_point_missing", BURIN_TEXT("ProgramProblem", "feed without a decimal point")},
}};
// A problem that was added without its wording would have an empty entry.
static_assert(!wordings.back().id.empty());

constexpr std::size_t longestShown = 40; // characters

/// The UTF-8 character at a position; empty if there is none.
std::string_view characterAt(std::string_view text, std::size_t at) noexcept {
    for (std::size_t bytes = 1; bytes <= std::min<std::size_t>(4, text.size() - at); ++bytes)
        if (isUtf8(text.substr(at, bytes))) return text.substr(at, bytes);
    return {};
}

/// Control characters, and characters that turn, break or hide text: they would be interpreted, not shown.
bool isObeyed(std::string_view character) noexcept {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(character[i]); };
    if (character.size() == 1) return byte(0) < 0x20 || byte(0) == 0x7F;
    if (character.size() == 2) return byte(0) == 0xC2 && byte(1) < 0xA0; // U+0080 … U+009F
    if (character.size() != 3) return false;
    const std::uint32_t point = (byte(0) & 0x0FU) << 12 | (byte(1) & 0x3FU) << 6 | (byte(2) & 0x3FU);
    return (point >= 0x200B && point <= 0x200F) || (point >= 0x2028 && point <= 0x202E) ||
           (point >= 0x2060 && point <= 0x206F) || point == 0xFEFF;
}

std::string escaped(std::string_view bytes) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string shown;
    for (const char c : bytes) {
        const auto byte = static_cast<std::uint8_t>(c);
        shown += {'\\', 'x', digits[byte >> 4], digits[byte & 0x0FU]};
    }
    return shown;
}

} // namespace

std::string_view idOf(ProgramProblem problem) noexcept {
    return wordings[static_cast<std::size_t>(problem)].id;
}

std::string_view wordingOf(ProgramProblem problem) noexcept {
    return textOf(problem).text;
}

TextId textOf(ProgramProblem problem) noexcept {
    return wordings[static_cast<std::size_t>(problem)].text;
}

std::string shownWords(std::string_view line, std::size_t from, std::size_t length) {
    std::string shown;
    std::size_t characters = 0;
    const std::size_t end = std::min(line.size(), from + std::min(length, line.size()));
    for (std::size_t at = from; at < end;) {
        std::string_view bytes = characterAt(line, at);
        const bool plain = !bytes.empty() && !isObeyed(bytes);
        if (bytes.empty()) bytes = line.substr(at, 1);
        const std::string next = plain ? std::string(bytes) : escaped(bytes);
        characters += plain ? 1 : next.size();
        if (characters > longestShown) return shown + "…";
        shown += next;
        at += bytes.size();
    }
    return shown;
}

} // namespace burin
