// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/dialect_data.h"

#include "core/base/json_object.h"
#include "core/nc/control.h"

#include <algorithm>
#include <span>

namespace burin {
namespace {

constexpr std::array<std::string_view, 4> homeWords{"rapid", "home_x", "home_y", "home_z"};
constexpr std::array<std::string_view, 15> blockWords{
    "units",   "work_offset", "blend",       "blend_end",      "tool",  "tool_2",   "speed",       "spindle",
    "coolant", "coolant_off", "start_dwell", "program_number", "rapid", "comments", "tool_comment"};

std::string listOf(std::span<const std::string_view> words) {
    std::string list;
    for (const std::string_view word : words) list += (list.empty() ? "{" : ", {") + std::string(word) + "}";
    return list;
}

/// Checks that words in braces are known ones; with `needed`, that there is one.
void checkWords(JsonObject& file, std::string_view key, const std::string& text,
                std::span<const std::string_view> known, bool needed = false) {
    bool found = false;
    for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', open + 1)) {
        const std::size_t close = text.find('}', open);
        const std::string word = text.substr(open + 1, close == std::string::npos ? close : close - open - 1);
        if (close == std::string::npos || std::ranges::find(known, word) == known.end())
            return file.fail(key, "has {" + word + "}, which is none of " + listOf(known));
        found = true;
    }
    if (needed && !found) file.fail(key, "has to hold one of " + listOf(known));
    if (text.find_first_of("\r\n") != std::string::npos) file.fail(key, "has to be one line");
}

std::string worded(JsonObject& file, std::string_view key, std::span<const std::string_view> known) {
    std::string text = file.text(key);
    checkWords(file, key, text, known, true);
    return text;
}

std::optional<std::string> optionalText(JsonObject& file, std::string_view key) {
    return file.has(key) ? std::optional<std::string>(file.text(key)) : std::nullopt;
}

/// Words that stand for separate blocks cannot be part of a block.
void checkAlone(JsonObject& file, std::string_view key, const std::string& text) {
    for (const std::string_view word : {"{comments}", "{tool_comment}"})
        if (text != word && text.find(word) != std::string::npos)
            file.fail(key, "has more than " + std::string(word) + ", which has to stand alone");
}

std::vector<std::string> blocks(JsonObject& file, std::string_view key,
                                std::span<const std::string_view> words = blockWords) {
    std::vector<std::string> texts = file.texts(key);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const std::string place = std::string(key) + "[" + std::to_string(i) + "]";
        checkWords(file, place, texts[i], words);
        checkAlone(file, place, texts[i]);
    }
    return texts;
}

void readNumbers(JsonObject& file, DialectData& dialect) {
    file.object("numbers", [&](JsonObject& numbers) {
        constexpr std::array<std::string_view, 2> units{"millimetre", "inch"};
        for (std::size_t i = 0; i < units.size(); ++i) {
            numbers.object(units[i], [&](JsonObject& unit) {
                dialect.numbers[i].decimals = unit.integer("decimals", 1, 6);
                dialect.numbers[i].feedDecimals = unit.integer("feed_decimals", 0, 6);
            });
        }
        dialect.forcedPoint = numbers.boolean("forced_point");
        dialect.leadingZero = numbers.boolean("leading_zero");
        dialect.keepZeros = numbers.boolean("keep_zeros");
    });
}

void readLines(JsonObject& file, DialectData& dialect) {
    file.object("lines", [&](JsonObject& lines) {
        dialect.lineLength = lines.integer("length", 30, 1000);
        dialect.lineNumberStep = lines.integer("number_step", 0, 1000);
    });
    file.object("comments", [&](JsonObject& comments) {
        dialect.commentOpen = comments.text("open");
        if (comments.has("close")) dialect.commentClose = comments.text("close");
        dialect.commentUpperCase = comments.boolean("upper_case");
        dialect.commentCharacters = optionalText(comments, "characters");
    });
}

void readWords(JsonObject& file, DialectData& dialect) {
    constexpr std::array<std::string_view, 2> dwell{"seconds", "milliseconds"};
    constexpr std::array<std::string_view, 1> tolerance{"tolerance"}, offset{"offset"};
    file.object("words", [&](JsonObject& words) {
        dialect.units = {words.text("millimetre"), words.text("inch")};
        dialect.rapid = words.text("rapid");
        dialect.line = words.text("line");
        dialect.clockwise = words.text("clockwise");
        dialect.anticlockwise = words.text("anticlockwise");
        dialect.planes = {words.text("plane_yz"), words.text("plane_zx"), words.text("plane_xy")};
        dialect.spindle = {words.text("spindle_clockwise"), words.text("spindle_anticlockwise")};
        dialect.coolant = {std::string(), optionalText(words, "mist"), optionalText(words, "flood")};
        if (words.has("coolant_off")) dialect.coolantOff = words.text("coolant_off");
        dialect.dwell = worded(words, "dwell", dwell);
        dialect.blend = optionalText(words, "blend");
        if (dialect.blend) checkWords(words, "blend", *dialect.blend, tolerance);
        dialect.exactStop = optionalText(words, "exact_stop");
        dialect.blendEnd = optionalText(words, "blend_end");
        dialect.workOffset = worded(words, "work_offset", offset);
        if (words.has("work_offset_59")) dialect.workOffset59 = worded(words, "work_offset_59", offset);
        if (words.has("further_work_offset")) {
            dialect.furtherWorkOffset = worded(words, "further_work_offset", offset);
            dialect.furtherWorkOffsets = words.integer("further_work_offsets", 1, 300);
        }
    });
}

void readArcs(JsonObject& file, DialectData& dialect) {
    file.object("arcs", [&](JsonObject& arcs) {
        dialect.arcs.largestSweep = arcs.number("largest_sweep_deg", {30.0, 360.0});
        dialect.arcs.smallestRadius = arcs.number("smallest_radius_mm", {0.001, 10.0});
        dialect.arcs.largestRadius = arcs.number("largest_radius_mm", {1.0, 1e5});
        dialect.arcs.largestMismatch = arcs.number("largest_mismatch_mm", {1e-5, 0.1});
        dialect.arcs.helices = arcs.boolean("helices");
    });
}

} // namespace

Result<DialectData> dialectFromJson(std::string_view text, const std::string& origin) {
    constexpr std::array<std::string_view, 4> heightWords{"rapid", "clear", "tool", "tool_2"};
    Result<JsonObject> file = JsonObject::parse(text, origin);
    if (!file) return file.error();
    DialectData dialect;
    dialect.id = file->text("id");
    dialect.name = file->text("name");
    dialect.source = file->text("source");
    dialect.fileSuffix = file->text("file_suffix");
    dialect.control = file->text("control");
    if (findControl(dialect.control) == nullptr) {
        std::string ids;
        for (const Control& control : controls()) ids += (ids.empty() ? "" : ", ") + std::string(control.id);
        file->fail("control", "has to be one of: " + ids);
    }
    readNumbers(*file, dialect);
    readLines(*file, dialect);
    readWords(*file, dialect);
    readArcs(*file, dialect);
    dialect.programNumberDigits = file->integer("program_number_digits", 1, 8);
    dialect.changesTools = file->boolean("changes_tools");
    dialect.planeBeforeHeight = file->boolean("plane_before_height");
    dialect.firstHeight = worded(*file, "first_height", heightWords);
    dialect.begin = blocks(*file, "begin");
    dialect.toolChange = blocks(*file, "tool_change");
    dialect.toolEnd = blocks(*file, "tool_end");
    dialect.end = blocks(*file, "end");
    if (file->has("speed_change")) dialect.speedChange = blocks(*file, "speed_change");
    if (file->has("coolant_change")) dialect.coolantChange = blocks(*file, "coolant_change");
    if (file->has("home")) dialect.home = blocks(*file, "home", homeWords);
    if (Result<void> read = file->finish(); !read) return read.error();
    return dialect;
}

} // namespace burin
