// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/tool.h"

#include "core/base/degrees.h"
#include "core/base/json_object.h"
#include "core/base/resource_folder.h"
#include "core/base/units.h"
#include "core/tool/preset_json.h"
#include "core/tool/segment_json.h"
#include "core/tool/tool_solid.h"

#include <nlohmann/json.hpp>

namespace burin {

namespace {

using namespace tool_range;

const std::vector<std::string_view>& typeNames() { // in the order of CutterType
    static const std::vector<std::string_view> names{"ball",  "flat",    "bull_nose", "taper",  "taper_ball",
                                                     "drill", "chamfer", "lollipop",  "profile"};
    return names;
}

void readProfile(JsonObject& from, std::vector<ProfileElement>& profile) {
    from.objects("profile", [&](JsonObject& element) {
        ProfileElement read{element.number("radius_mm", length), element.number("height_mm", length), 0.0, false};
        if (element.has("arc_radius_mm")) {
            read.arcRadius = element.number("arc_radius_mm", length);
            read.hollow = element.booleanOr("hollow", false);
        }
        profile.push_back(read);
    });
}

void readCutter(JsonObject& from, Cutter& cutter) {
    cutter.type = static_cast<CutterType>(from.choice("type", typeNames()));
    cutter.diameter = from.number("diameter_mm", length);
    cutter.cornerRadius = from.number("corner_radius_mm", length);
    cutter.tipDiameter = from.numberOr("tip_diameter_mm", 0.0, length);
    cutter.taperAngle = from.numberOr("taper_angle_deg", 0.0, taper) * pi / 180.0;
    if (from.has("profile")) readProfile(from, cutter.profile);
    cutter.fluteLength = from.number("flute_length_mm", length);
    cutter.shankDiameter = from.number("shank_diameter_mm", length);
    cutter.stickOut = from.number("stick_out_mm", length);
    readSegments(from, "holder", cutter.holder);
    if (!from.booleanOr("turns", true))
        cutter.solid = std::make_shared<const ToolSolid>(readSolid(from));
    else if (from.has("section"))
        cutter.solid = std::make_shared<const ToolSolid>(readTurningSolid(from, cutter.profile));
}

/// Reads values that may be missing: files of older tools do not have them. A source for a key that the file lacks is
/// an error.
void readLimits(JsonObject& file, Tool& tool) {
    tool.modulus = file.numberOr("modulus_n_per_mm2", 0.0, stiffness);
    tool.strength = file.numberOr("strength_n_per_mm2", 0.0, breakage);
    tool.maximumChipLoad = file.numberOr("maximum_chip_load_mm", 0.0, length);
    tool.maximumWidthOfCut = file.numberOr("maximum_width_of_cut_mm", 0.0, length);
    if (!file.has("sources")) return;
    tool.sources = file.textsByName("sources");
    for (const auto& [key, source] : tool.sources)
        if (!file.has(key)) file.fail("sources." + key, "names no key of this file");
}

void writeLimits(const Tool& tool, nlohmann::ordered_json& file) {
    const auto write = [&](const char* key, double value) {
        if (value > 0.0) file[key] = value;
    };
    write("modulus_n_per_mm2", tool.modulus);
    write("strength_n_per_mm2", tool.strength);
    write("maximum_chip_load_mm", tool.maximumChipLoad);
    write("maximum_width_of_cut_mm", tool.maximumWidthOfCut);
    if (!tool.sources.empty()) file["sources"] = tool.sources;
}

nlohmann::ordered_json profileJson(const std::vector<ProfileElement>& profile) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const ProfileElement& element : profile) {
        nlohmann::ordered_json entry{{"radius_mm", element.radius}, {"height_mm", element.height}};
        if (element.arcRadius > 0.0) {
            entry["arc_radius_mm"] = element.arcRadius;
            entry["hollow"] = element.hollow;
        }
        list.push_back(entry);
    }
    return list;
}

nlohmann::ordered_json cutterJson(const Cutter& cutter) {
    nlohmann::ordered_json holder = nlohmann::ordered_json::array();
    for (const HolderSegment& segment : cutter.holder)
        holder.push_back({{"lower_diameter_mm", segment.lowerDiameter},
                          {"upper_diameter_mm", segment.upperDiameter},
                          {"length_mm", segment.length}});
    nlohmann::ordered_json json{{"type", cutterTypeName(cutter.type)},
                                {"diameter_mm", cutter.diameter},
                                {"corner_radius_mm", cutter.cornerRadius}};
    if (cutter.tipDiameter > 0.0) json["tip_diameter_mm"] = cutter.tipDiameter;
    if (cutter.taperAngle > 0.0) json["taper_angle_deg"] = roundedDegrees(cutter.taperAngle);
    if (!cutter.profile.empty()) json["profile"] = profileJson(cutter.profile);
    json["flute_length_mm"] = cutter.fluteLength;
    json["shank_diameter_mm"] = cutter.shankDiameter;
    json["stick_out_mm"] = cutter.stickOut;
    json["holder"] = holder;
    if (cutter.solid != nullptr) writeSolid(*cutter.solid, json);
    return json;
}

} // namespace

std::string_view cutterTypeName(CutterType type) noexcept {
    return typeNames()[static_cast<std::size_t>(type)];
}

Result<Tool> toolFromJson(std::string_view text, const std::string& origin) {
    Result<JsonObject> file = JsonObject::parse(text, origin);
    if (!file) return file.error();
    Tool tool;
    tool.id = file->text("id");
    tool.name = file->text("name");
    tool.number = file->integer("number", 1, highestNumber);
    tool.fluteCount = file->integer("flute_count", 1, mostFlutes);
    tool.centreCutting = file->boolean("centre_cutting");
    tool.maximumDepthOfCut = file->number("maximum_depth_of_cut_mm", length);
    tool.maximumSpindleSpeed = file->number("maximum_spindle_speed_rpm", spindleSpeed);
    tool.source = file->text("source");
    if (file->has("presets")) readPresets(*file, tool.presets);
    readLimits(*file, tool);
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
    ordered_json file{{"id", tool.id},
                      {"name", tool.name},
                      {"number", tool.number},
                      {"flute_count", tool.fluteCount},
                      {"centre_cutting", tool.centreCutting},
                      {"maximum_depth_of_cut_mm", tool.maximumDepthOfCut},
                      {"maximum_spindle_speed_rpm", tool.maximumSpindleSpeed},
                      {"source", tool.source}};
    writeLimits(tool, file);
    if (!tool.presets.empty()) file["presets"] = presetsJson(tool.presets);
    file["cutter"] = cutterJson(tool.cutter);
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
