// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// CAMotics' tools: src/gcode/Tool.cpp and ToolShape.h of its sources. FreeCAD's .ctbl is the same object.
#include "core/base/clean_text.h"
#include "core/base/numbers.h"
#include "core/tool/foreign_tool.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>

namespace burin {

namespace {

using nlohmann::json;

struct Form {
    std::string_view name;
    CutterType type;
};
/// For writing, the first entry of a type is used.
constexpr std::array forms{Form{"cylindrical", CutterType::flat}, Form{"cylinder", CutterType::flat},
                           Form{"ballnose", CutterType::ball},    Form{"ball", CutterType::ball},
                           Form{"conical", CutterType::chamfer},  Form{"cone", CutterType::chamfer},
                           Form{"snubnose", CutterType::taper}};

bool isNumber(const std::string& text) {
    return !text.empty() && std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c) != 0; });
}

double valueOf(const json& item, const char* key) {
    const auto found = item.find(key);
    return found != item.end() && found->is_number() ? found->get<double>() : 0.0;
}

std::string textOf(const json& item, const char* key) {
    const auto found = item.find(key);
    std::string text = found != item.end() && found->is_string() ? found->get<std::string>() : std::string();
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// Sets a cone over the entire length, as the table contains nothing else.
void shape(Cutter& cutter, double length, double tip) {
    cutter.tipDiameter = tip;
    cutter.taperAngle = std::atan2(0.5 * (cutter.diameter - tip), length);
    cutter.cornerRadius = 0.0;
}

std::optional<ReadTool> toolOf(const std::string& number, const json& item, const Tool& like) {
    const auto form = std::ranges::find(forms, textOf(item, "shape"), &Form::name);
    if (form == forms.end()) return std::nullopt;
    const std::string units = textOf(item, "units");
    const double unit = units == "imperial" || units == "inch" ? 25.4 : 1.0;
    ReadTool read;
    Tool& tool = read.tool;
    tool = like;
    const auto described = item.find("description");
    tool.name = described != item.end() && described->is_string() ? cleanLine(described->get<std::string>()) : "";
    if (tool.name.empty()) tool.name = "Tool " + number;
    tool.number = static_cast<int>(std::lround(std::min(parseNumber(number).value_or(0.0), 1e9)));
    tool.source = "CAMotics tool table";
    tool.sources.clear();
    tool.presets.clear();
    Cutter& cutter = tool.cutter;
    cutter.profile.clear();
    cutter.type = form->type;
    cutter.diameter = valueOf(item, "diameter") * unit;
    cutter.fluteLength = valueOf(item, "length") * unit;
    cutter.shankDiameter = cutter.diameter;
    cutter.cornerRadius = cutter.type == CutterType::ball ? cutter.radius() : 0.0;
    cutter.tipDiameter = cutter.taperAngle = 0.0;
    if (cutter.type == CutterType::chamfer) shape(cutter, cutter.fluteLength, 0.0);
    if (cutter.type == CutterType::taper) shape(cutter, cutter.fluteLength, valueOf(item, "snub_diameter") * unit);
    cutter.stickOut = std::max(like.cutter.stickOut, cutter.fluteLength);
    read.notes.push_back("Number of flutes, stick-out, holder and limits are those of " + like.id +
                         ", and the shank is as wide as the cutter: enter your own.");
    return read;
}

/// Returns the entry of a tool, with the length that the table would give the flutes; empty for shapes that a table
/// does not have.
std::optional<json> itemOf(const Tool& tool) {
    const Cutter& cutter = tool.cutter;
    json item{{"units", "metric"},
              {"shape", "cylindrical"},
              {"length", cutter.fluteLength},
              {"diameter", cutter.diameter},
              {"description", tool.name}};
    if (cutter.type == CutterType::flat) return item;
    if (cutter.type == CutterType::ball) {
        item["shape"] = "ballnose";
        return item;
    }
    const bool cone =
        cutter.type == CutterType::chamfer || (cutter.type == CutterType::taper && cutter.cornerRadius == 0.0);
    if (!cone) return std::nullopt;
    item["shape"] = cutter.tipDiameter > 0.0 ? "snubnose" : "conical";
    item["length"] = 0.5 * (cutter.diameter - cutter.tipDiameter) / std::tan(cutter.taperAngle);
    if (cutter.tipDiameter > 0.0) item["snub_diameter"] = cutter.tipDiameter;
    return item;
}

} // namespace

bool isCamoticsTable(const json& table) {
    if (!table.is_object() || table.empty()) return false;
    for (const auto& [number, item] : table.items())
        if (!isNumber(number) || !item.is_object() || !item.contains("shape")) return false;
    return true;
}

Result<ReadTools> readCamotics(const json& tools, const std::string& origin, const Tool& like) {
    ReadTools read;
    for (const auto& [number, item] : tools.items()) {
        std::optional<ReadTool> tool = toolOf(number, item, like);
        if (!tool) {
            read.leftOut.push_back("T" + number + ": Burin does not support this shape.");
            continue;
        }
        Result<ReadTool> sound = soundTool(std::move(*tool), origin, like);
        if (sound)
            read.tools.push_back(std::move(*sound));
        else
            read.leftOut.push_back("T" + number + ": " + sound.error().place + " " + sound.error().detail + ".");
    }
    return read;
}

Result<WrittenTools> camoticsTable(const std::vector<Tool>& tools) {
    WrittenTools written;
    json table = json::object();
    std::set<int> numbers;
    for (const Tool& tool : tools) {
        const std::optional<json> item = itemOf(tool);
        if (!item) {
            written.notes.push_back(tool.id + ": CAMotics does not support this shape.");
            continue;
        }
        if (!numbers.insert(tool.number).second)
            return Error{ErrorCode::argumentInvalid, "number of " + tool.id, std::to_string(tool.number),
                         "a number that no other tool has"};
        table[std::to_string(tool.number)] = *item;
        const double cone = item->at("length").get<double>();
        if (cone < tool.cutter.fluteLength - 1e-9)
            written.notes.push_back(tool.id + ": CAMotics stores only the cone, not the cylinder above it.");
    }
    if (table.empty()) return Error{ErrorCode::notSupported, "a CAMotics tool table of these tools", "other forms", ""};
    written.text = table.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
    written.notes.emplace_back("Flutes, shank, holder and limits can't be stored in this format.");
    noteLostPresets(tools, written);
    return written;
}

} // namespace burin
