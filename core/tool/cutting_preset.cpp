// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/cutting_preset.h"

#include "core/base/clean_text.h"
#include "core/base/numbers.h"
#include "core/base/resource_folder.h"
#include "core/tool/tool.h"
#include "core/tool/tool_ranges.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace burin {

namespace {

using namespace tool_range;

bool isWithin(double value, NumberRange range) noexcept {
    return value >= range.low && value <= range.high; // false if it is not a number
}

Error invalidPreset(const std::string& key, std::string value, std::string allowed) {
    return {ErrorCode::argumentInvalid, key, std::move(value), std::move(allowed)};
}

Result<void> validateNumbers(const CuttingPreset& preset, const std::string& path, const Tool& tool) {
    const auto outside = [&](const char* key, double value, NumberRange range) {
        return invalidPreset(path + key, formatShortest(value),
                             "a number from " + formatShortest(range.low) + " to " + formatShortest(range.high));
    };
    if (!isWithin(preset.spindleSpeed, presetSpeed))
        return outside("spindle_speed_rpm", preset.spindleSpeed, presetSpeed);
    if ((preset.feed != 0.0) == (preset.chipLoad != 0.0))
        return invalidPreset(path + "feed_mm_per_min", formatShortest(preset.feed),
                             "required without chip_load_mm, not allowed with it");
    const std::array optional{std::tuple{"feed_mm_per_min", preset.feed, presetFeed},
                              std::tuple{"chip_load_mm", preset.chipLoad, presetChipLoad},
                              std::tuple{"plunge_feed_mm_per_min", preset.plungeFeed, presetFeed},
                              std::tuple{"step_down_mm", preset.stepDown, presetStep},
                              std::tuple{"step_over_mm", preset.stepOver, presetStep}};
    for (const auto& [key, value, range] : optional)
        if (value != 0.0 && !isWithin(value, range)) return outside(key, value, range);
    if (preset.stepDown > tool.maximumDepthOfCut)
        return invalidPreset(path + "step_down_mm", formatShortest(preset.stepDown),
                             "at most maximum_depth_of_cut_mm (" + formatShortest(tool.maximumDepthOfCut) + ")");
    if (preset.stepOver > tool.cutter.radius())
        return invalidPreset(path + "step_over_mm", formatShortest(preset.stepOver),
                             "at most half of diameter_mm (" + formatShortest(tool.cutter.radius()) + ")");
    return {};
}

} // namespace

double feedOf(const CuttingPreset& preset, int fluteCount) noexcept {
    return preset.feed > 0.0 ? preset.feed : preset.spindleSpeed * fluteCount * preset.chipLoad;
}

const CuttingPreset* presetFor(const Tool& tool, std::string_view material, std::string_view base) noexcept {
    const auto of = [&tool](std::string_view id) -> const CuttingPreset* {
        const auto found = std::ranges::find(tool.presets, id, &CuttingPreset::material);
        return found == tool.presets.end() ? nullptr : &*found;
    };
    for (const std::string_view id : {material, base})
        if (const CuttingPreset* found = id.empty() ? nullptr : of(id)) return found;
    return of({});
}

Result<void> validatePresets(const Tool& tool) {
    for (std::size_t i = 0; i < tool.presets.size(); ++i) {
        const CuttingPreset& preset = tool.presets[i];
        const std::string path = "presets[" + std::to_string(i) + "].";
        if (preset.name.find_first_not_of(' ') == std::string::npos || cleanLine(preset.name) != preset.name)
            return invalidPreset(path + "name", preset.name, "one line of text that is not empty");
        if (std::ranges::count(tool.presets, preset.name, &CuttingPreset::name) > 1)
            return invalidPreset(path + "name", preset.name, "a name that no other preset of the tool has");
        if (!preset.material.empty() && !isResourceId(preset.material))
            return invalidPreset(path + "material", preset.material,
                                 "letters, digits, '-', '_' and '.', a letter or digit first");
        if (Result<void> valid = validateNumbers(preset, path, tool); !valid) return valid;
    }
    return {};
}

std::string freePresetName(const std::vector<CuttingPreset>& presets, const std::string& name) {
    std::string free = name;
    for (int i = 2; std::ranges::find(presets, free, &CuttingPreset::name) != presets.end(); ++i)
        free = name + " " + std::to_string(i);
    return free;
}

} // namespace burin
