// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/clean_text.h"
#include "core/base/numbers.h"
#include "core/base/resource_folder.h"
#include "core/base/trimmed.h"
#include "core/base/units.h"
#include "core/tool/foreign_tool.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

using nlohmann::json;

/// Numbers that were converted by pi end in digits that nobody entered.
double tidied(double value) noexcept {
    constexpr double steps = 1e6;
    const double rounded = std::round(value * steps) / steps;
    return rounded > 0.0 ? rounded : value;
}

std::string plainLine(std::string_view text) {
    return cleanLine(trimmed(text));
}

} // namespace

std::string textIn(const nlohmann::json& of, const char* key) {
    const auto found = of.find(key);
    return found != of.end() && found->is_string() ? found->get<std::string>() : std::string();
}

double numberIn(const nlohmann::json& of, const char* key) {
    const auto found = of.find(key);
    return found != of.end() && found->is_number() ? found->get<double>() : 0.0;
}

double surfaceSpeedOf(double spindleSpeed, double diameter) noexcept {
    return pi * diameter * spindleSpeed / millimetresPerMetre;
}

double spindleSpeedOf(double surfaceSpeed, double diameter) noexcept {
    return tidied(surfaceSpeed * millimetresPerMetre / (pi * diameter));
}

void addForeignPreset(CuttingPreset preset, std::string_view material, ReadTool& read) {
    preset.name = plainLine(preset.name);
    if (preset.name.empty()) preset.name = "Preset";
    preset.name = freePresetName(read.tool.presets, preset.name);
    if (const std::string name = plainLine(material); !name.empty()) {
        const std::vector<std::string> known = resourceIds(materialResource);
        const auto isKnown = [&](const std::string& id) { return std::ranges::find(known, id) != known.end(); };
        preset.material = isKnown(name) ? name : resourceIdFrom(name);
        if (preset.material.empty()) {
            read.notes.push_back("Preset \"" + preset.name + "\" was left out: no material can be called \"" + name +
                                 "\".");
            return;
        }
        if (!isKnown(preset.material))
            read.notes.push_back("Preset \"" + preset.name + "\" is for \"" + name +
                                 "\", a material that Burin does not have: choose its material.");
    }
    read.tool.presets.push_back(std::move(preset));
}

void keepSoundPresets(ReadTool& read) {
    Tool& tool = read.tool;
    const auto leaveOut = [&read](double& step, double most, const CuttingPreset& preset, const char* what) {
        if (!(step > most)) return;
        read.notes.push_back("Preset \"" + preset.name + "\": the " + what + " of " + formatShortest(step) +
                             " mm was left out, as the tool allows " + formatShortest(most) + " mm.");
        step = 0.0;
    };
    std::vector<CuttingPreset> presets = std::move(tool.presets);
    tool.presets.clear();
    for (CuttingPreset& preset : presets) {
        leaveOut(preset.stepDown, tool.maximumDepthOfCut, preset, "step-down");
        leaveOut(preset.stepOver, tool.cutter.radius(), preset, "step-over");
        tool.presets.push_back(preset);
        if (const Result<void> valid = validatePresets(tool); !valid) {
            const Error& fault = valid.error();
            const std::string key = fault.subject.substr(fault.subject.find('.') + 1);
            read.notes.push_back("Preset \"" + preset.name + "\" was left out: " + key + " has to be " + fault.detail +
                                 ".");
            tool.presets.pop_back();
        }
    }
}

void noteLostPresets(const std::vector<Tool>& tools, WrittenTools& written) {
    if (std::ranges::any_of(tools, [](const Tool& tool) { return !tool.presets.empty(); }))
        written.notes.emplace_back("Presets of feeds and speeds can't be stored in this format.");
}

void readFreecadPresets(const json& bit, ReadTool& read) {
    const auto list = bit.find("presets");
    if (list == bit.end() || !list->is_array()) return;
    const Tool& tool = read.tool;
    for (const json& each : *list) {
        if (!each.is_object()) continue;
        CuttingPreset preset;
        preset.name = textIn(each, "name");
        preset.spindleSpeed = spindleSpeedOf(numberIn(each, "surface_speed"), tool.cutter.diameter);
        preset.chipLoad = numberIn(each, "chipload");
        preset.plungeFeed = tidied(feedOf(preset, tool.fluteCount) * numberIn(each, "vert_feed_ratio"));
        const auto hint = each.find("material_hint");
        const std::string material = hint != each.end() && hint->is_object() ? textIn(*hint, "name") : std::string();
        if (preset.name.empty()) preset.name = material;
        if (const std::string only = textIn(each, "op_type_hint"); !only.empty())
            read.notes.push_back("Preset \"" + plainLine(preset.name) + "\" is for one operation (" + plainLine(only) +
                                 "): Burin uses it for all passes.");
        if (!textIn(each, "notes").empty())
            read.notes.push_back("Preset \"" + plainLine(preset.name) + "\": its remarks were not imported.");
        addForeignPreset(std::move(preset), material, read);
    }
}

nlohmann::ordered_json freecadPresets(const Tool& tool) {
    using nlohmann::ordered_json;
    ordered_json list = ordered_json::array();
    for (const CuttingPreset& preset : tool.presets) {
        const double feed = feedOf(preset, tool.fluteCount);
        ordered_json entry{{"name", preset.name},
                           {"material_hint", nullptr},
                           {"op_type_hint", nullptr},
                           {"surface_speed", surfaceSpeedOf(preset.spindleSpeed, tool.cutter.diameter)},
                           {"chipload", feed / (preset.spindleSpeed * tool.fluteCount)}};
        if (!preset.material.empty()) entry["material_hint"] = {{"uuid", nullptr}, {"name", preset.material}};
        if (preset.plungeFeed > 0.0) entry["vert_feed_ratio"] = preset.plungeFeed / feed;
        entry["notes"] = nullptr;
        list.push_back(std::move(entry));
    }
    return list;
}

} // namespace burin
