// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// LinuxCNC's tool table: linuxcnc.org/docs/html/gcode/tool-compensation.html.
#include "core/base/clean_text.h"
#include "core/base/numbers.h"
#include "core/tool/foreign_tool.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

namespace burin {

namespace {

/// A line, split into words and the comment.
struct Line {
    std::vector<std::string> words;
    std::string remark;
};

Line lineOf(const std::string& text) {
    Line line;
    const std::size_t end = text.find(';');
    if (end != std::string::npos) line.remark = cleanLine(text.substr(end + 1));
    std::istringstream words(text.substr(0, end));
    for (std::string word; words >> word;) line.words.push_back(word);
    return line;
}

/// Returns the number after a letter; empty if there is no such word, or no number.
std::optional<double> valueOf(const Line& line, char letter) {
    for (const std::string& word : line.words)
        if (std::toupper(static_cast<unsigned char>(word.front())) == letter) return parseNumber(word.substr(1));
    return std::nullopt;
}

} // namespace

bool isLinuxcncTable(std::string_view text) {
    std::istringstream lines{std::string(text.substr(0, 65536))};
    for (std::string line; std::getline(lines, line);)
        if (const auto number = valueOf(lineOf(line), 'T'); number && *number >= 1.0) return true;
    return false;
}

Result<ReadTools> readLinuxcnc(std::string_view text, const std::string& origin, const Tool& like, double unit) {
    ReadTools read;
    std::istringstream lines{std::string(text)};
    for (std::string each; std::getline(lines, each);) {
        const Line line = lineOf(each);
        const std::optional<double> number = valueOf(line, 'T'), diameter = valueOf(line, 'D');
        if (!number) continue;
        const std::string name = "T" + formatShortest(*number);
        if (!diameter || !(*diameter > 0.0)) {
            read.leftOut.push_back(name + ": the diameter is missing.");
            continue;
        }
        ReadTool tool{like, {}};
        tool.tool.name = line.remark.empty() ? "Tool " + formatShortest(*number) : line.remark;
        tool.tool.number = static_cast<int>(std::lround(std::min(*number, 1e9)));
        tool.tool.source = "LinuxCNC tool table";
        tool.tool.sources.clear();
        tool.tool.presets.clear();
        Cutter& cutter = tool.tool.cutter;
        cutter.shankDiameter = cutter.diameter = *diameter * unit;
        cutter.cornerRadius = cutter.type == CutterType::ball ? cutter.radius() : cutter.cornerRadius;
        tool.notes.push_back("The table gives only number, diameter and name. Everything else is that of " + like.id +
                             ", and the shank is as wide as the cutter: enter your own.");
        Result<ReadTool> sound = soundTool(std::move(tool), origin, like);
        if (sound)
            read.tools.push_back(std::move(*sound));
        else
            read.leftOut.push_back(name + ": " + sound.error().place + " " + sound.error().detail + ".");
    }
    return read;
}

Result<WrittenTools> linuxcncTable(std::vector<Tool> tools, double unit) {
    constexpr int mostPockets = 1000, decimals = 6;
    std::ranges::sort(tools, {}, &Tool::number);
    WrittenTools written;
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const Tool& tool = tools[i];
        const std::string number = std::to_string(tool.number);
        if (i > 0 && tools[i - 1].number == tool.number)
            return Error{ErrorCode::argumentInvalid, "number of " + tool.id, number,
                         "a number that no other tool has (" + tools[i - 1].id + " has it)"};
        if (tool.number > mostPockets)
            return Error{ErrorCode::argumentInvalid, "number of " + tool.id, number,
                         "1 to 1000: it is the pocket, too"};
        written.text += "T" + number + " P" + number + " Z0 D" + formatFixed(tool.cutter.diameter / unit, decimals) +
                        " ;" + cleanLine(tool.name) + "\n";
    }
    written.notes.emplace_back("Lengths are 0: measure them on the machine.");
    noteLostPresets(tools, written);
    return written;
}

} // namespace burin
