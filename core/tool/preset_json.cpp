// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/preset_json.h"

#include "core/tool/tool_ranges.h"

#include <nlohmann/json.hpp>

namespace burin {

void readPresets(JsonObject& file, std::vector<CuttingPreset>& presets) {
    using namespace tool_range;
    file.objects("presets", [&](JsonObject& from) {
        CuttingPreset preset;
        preset.name = from.text("name");
        if (from.has("material")) preset.material = from.text("material");
        preset.spindleSpeed = from.number("spindle_speed_rpm", presetSpeed);
        preset.feed = from.numberOr("feed_mm_per_min", 0.0, presetFeed);
        preset.chipLoad = from.numberOr("chip_load_mm", 0.0, presetChipLoad);
        preset.plungeFeed = from.numberOr("plunge_feed_mm_per_min", 0.0, presetFeed);
        preset.stepDown = from.numberOr("step_down_mm", 0.0, presetStep);
        preset.stepOver = from.numberOr("step_over_mm", 0.0, presetStep);
        if (from.has("coolant"))
            preset.coolant = static_cast<Coolant>(
                from.choice("coolant", {idOf(Coolant::off), idOf(Coolant::mist), idOf(Coolant::flood)}));
        presets.push_back(std::move(preset));
    });
}

nlohmann::ordered_json presetsJson(const std::vector<CuttingPreset>& presets) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const CuttingPreset& preset : presets) {
        nlohmann::ordered_json entry{{"name", preset.name}};
        if (!preset.material.empty()) entry["material"] = preset.material;
        entry["spindle_speed_rpm"] = preset.spindleSpeed;
        const auto write = [&entry](const char* key, double value) {
            if (value != 0.0) entry[key] = value;
        };
        write("feed_mm_per_min", preset.feed);
        write("chip_load_mm", preset.chipLoad);
        write("plunge_feed_mm_per_min", preset.plungeFeed);
        write("step_down_mm", preset.stepDown);
        write("step_over_mm", preset.stepOver);
        if (preset.coolant) entry["coolant"] = idOf(*preset.coolant);
        list.push_back(std::move(entry));
    }
    return list;
}

} // namespace burin
