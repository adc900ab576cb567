// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/tool.h"

#include "core/base/json_object.h"
#include "core/base/resource_folder.h"

namespace burin {

namespace {

// Far beyond any tool: catches a slip of the unit or of a digit.
constexpr NumberRange length{0.0, 1000.0};
constexpr NumberRange spindleSpeed{0.0, 1e6};
constexpr int highestNumber = 99999; // LinuxCNC's highest tool number

const std::vector<std::string_view>& typeNames() { // in the order of CutterType
    static const std::vector<std::string_view> names{"ball", "flat", "bull_nose"};
    return names;
}

void readCutter(JsonObject& from, Cutter& cutter) {
    cutter.type = static_cast<CutterType>(from.choice("type", typeNames()));
    cutter.diameter = from.number("diameter_mm", length);
    cutter.cornerRadius = from.number("corner_radius_mm", length);
    cutter.fluteLength = from.number("flute_length_mm", length);
    cutter.shankDiameter = from.number("shank_diameter_mm", length);
    cutter.stickOut = from.number("stick_out_mm", length);
    from.objects("holder", [&](JsonObject& segment) {
        cutter.holder.push_back({segment.number("lower_diameter_mm", length),
                                 segment.number("upper_diameter_mm", length), segment.number("length_mm", length)});
    });
}

} // namespace

Result<Tool> toolFromJson(std::string_view text, const std::string& origin) {
    Result<JsonObject> file = JsonObject::parse(text, origin);
    if (!file) return file.error();
    Tool tool;
    tool.id = file->text("id");
    tool.name = file->text("name");
    tool.number = file->integer("number", 1, highestNumber);
    tool.fluteCount = file->integer("flute_count", 1, 100);
    tool.centreCutting = file->boolean("centre_cutting");
    tool.maximumDepthOfCut = file->number("maximum_depth_of_cut_mm", length);
    tool.maximumSpindleSpeed = file->number("maximum_spindle_speed_rpm", spindleSpeed);
    tool.source = file->text("source");
    file->object("cutter", [&](JsonObject& cutter) { readCutter(cutter, tool.cutter); });
    if (Result<void> read = file->finish(); !read) return read.error();
    if (Result<void> valid = validate(tool); !valid) {
        const Error& fault = valid.error();
        return Error{ErrorCode::resourceInvalid, origin, fault.subject, "has to be " + fault.detail};
    }
    return tool;
}

std::string toJson(const Tool& tool) {
    using nlohmann::ordered_json;
    ordered_json holder = ordered_json::array();
    for (const HolderSegment& segment : tool.cutter.holder)
        holder.push_back({{"lower_diameter_mm", segment.lowerDiameter},
                          {"upper_diameter_mm", segment.upperDiameter},
                          {"length_mm", segment.length}});
    const ordered_json cutter{{"type", typeNames()[static_cast<std::size_t>(tool.cutter.type)]},
                              {"diameter_mm", tool.cutter.diameter},
                              {"corner_radius_mm", tool.cutter.cornerRadius},
                              {"flute_length_mm", tool.cutter.fluteLength},
                              {"shank_diameter_mm", tool.cutter.shankDiameter},
                              {"stick_out_mm", tool.cutter.stickOut},
                              {"holder", holder}};
    const ordered_json file{{"id", tool.id},
                            {"name", tool.name},
                            {"number", tool.number},
                            {"flute_count", tool.fluteCount},
                            {"centre_cutting", tool.centreCutting},
                            {"maximum_depth_of_cut_mm", tool.maximumDepthOfCut},
                            {"maximum_spindle_speed_rpm", tool.maximumSpindleSpeed},
                            {"source", tool.source},
                            {"cutter", cutter}};
    // Text that is not UTF-8 is replaced: an exception must not leave this library.
    return file.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

Result<Tool> loadTool(std::string_view id) {
    Result<ResourceText> file = findResource(toolResource, id);
    if (!file) return file.error();
    Result<Tool> tool = toolFromJson(file->text, file->file);
    if (tool && tool->id != id) return Error{ErrorCode::resourceInvalid, file->file, "id", "has to be the file's name"};
    return tool;
}

std::vector<std::string> toolIds() {
    return resourceIds(toolResource);
}

} // namespace burin
