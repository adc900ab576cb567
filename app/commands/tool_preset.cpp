// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/commands/tool_commands.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/tool/preset_json.h"
#include "core/volume/runs/property_list.h"

#include <algorithm>
#include <optional>

namespace burin {

namespace {

struct PresetArguments {
    std::shared_ptr<const LibraryArguments> tools;
    std::string id, name;
    std::optional<std::string> material, coolant;
    std::optional<double> speed, feed, chipLoad, plungeFeed, stepDown, stepOver;
    bool first = false, remove = false;
};

/// Errors: nameUnknown (no such material).
Result<void> changePreset(const PresetArguments& arguments, CuttingPreset& preset) {
    if (arguments.material) {
        const bool any = *arguments.material == "any";
        if (!any)
            if (const Result<Property> known = loadMaterial(*arguments.material); !known) return known.error();
        preset.material = any ? std::string() : *arguments.material;
    }
    const auto set = [](const std::optional<double>& stated, double& value) {
        if (stated) value = *stated;
    };
    set(arguments.speed, preset.spindleSpeed);
    if (arguments.feed || arguments.chipLoad) { // one replaces the other
        preset.feed = arguments.feed.value_or(0.0);
        preset.chipLoad = arguments.chipLoad.value_or(0.0);
    }
    set(arguments.plungeFeed, preset.plungeFeed);
    set(arguments.stepDown, preset.stepDown);
    set(arguments.stepOver, preset.stepOver);
    if (!arguments.coolant) return {};
    preset.coolant.reset();
    for (const Coolant coolant : {Coolant::off, Coolant::mist, Coolant::flood})
        if (idOf(coolant) == *arguments.coolant) preset.coolant = coolant;
    return {};
}

std::string linesOfPresets(const Tool& tool) {
    std::string lines;
    for (const CuttingPreset& preset : tool.presets)
        lines +=
            "\n  " + worded(BURIN_TEXT("Command", "%1 (%2): %3 1/min, %4 mm/min"),
                            {preset.name,
                             preset.material.empty() ? worded(BURIN_TEXT("Command", "any material")) : preset.material,
                             formatShortest(preset.spindleSpeed), formatShortest(feedOf(preset, tool.fluteCount))});
    return lines;
}

int changePresets(const PresetArguments& arguments, CommandContext& context) {
    Result<Tool> tool = listedTool(arguments.id, arguments.tools->library);
    if (!tool) return context.fail(tool.error());
    std::vector<CuttingPreset>& presets = tool->presets;
    auto preset = std::ranges::find(presets, arguments.name, &CuttingPreset::name);
    if (arguments.remove && preset == presets.end()) {
        std::string names;
        for (const CuttingPreset& each : presets) names += (names.empty() ? "" : ", ") + each.name;
        return context.fail({ErrorCode::nameUnknown, "preset", arguments.name, names});
    }
    if (preset == presets.end()) {
        presets.emplace_back().name = arguments.name;
        preset = presets.end() - 1;
    }
    if (arguments.remove)
        presets.erase(preset);
    else if (const Result<void> changed = changePreset(arguments, *preset); !changed)
        return context.fail(changed.error());
    else if (arguments.first)
        std::rotate(presets.begin(), preset, preset + 1);
    if (const Result<void> valid = validatePresets(*tool); !valid) return context.fail(valid.error());
    tool->sources["presets"] = "entered by the user";
    if (presets.empty()) tool->sources.erase("presets");
    return keepTool(*tool, true, {}, context, {{"presets", presetsJson(presets)}}, linesOfPresets(*tool));
}

} // namespace

void registerToolPreset(CommandParser tools, std::shared_ptr<const LibraryArguments> chosen, CommandContext& context,
                        int& status) {
    auto arguments = std::make_shared<PresetArguments>();
    arguments->tools = std::move(chosen);
    const CommandParser preset = tools.command(
        "preset", BURIN_TEXT("Help", "Add or change a preset of feeds and speeds of one of your own tools. Paths use "
                                     "the first preset for the material of the stock, without one the first for any "
                                     "material, without one the values that the material states"));
    preset.passOn();
    preset.positional(BURIN_TEXT("Argument", "ID"), arguments->id, BURIN_TEXT("Help", "Tool")).required();
    preset.positional(BURIN_TEXT("Argument", "NAME"), arguments->name, BURIN_TEXT("Help", "Name of the preset"))
        .required();
    preset.option("--material", arguments->material, BURIN_TEXT("Help", "Material that it is for, or any"));
    preset.option("--speed", arguments->speed, BURIN_TEXT("Help", "Speed of the spindle, 1/min"));
    const Argument feed = preset.option("--feed", arguments->feed, BURIN_TEXT("Help", "Feed, mm/min"));
    preset.option("--feed-per-tooth", arguments->chipLoad, BURIN_TEXT("Help", "Feed per tooth instead, mm"))
        .excludes(feed);
    preset.option("--plunge-feed", arguments->plungeFeed,
                  BURIN_TEXT("Help", "Plunge feed, mm/min; 0: the share of the feed that the material states"));
    preset.option("--step-down", arguments->stepDown,
                  BURIN_TEXT("Help", "Depth of a level, mm; 0: what material, tool and spindle can take"));
    preset.option("--step-over", arguments->stepOver,
                  BURIN_TEXT("Help", "Distance between the loops of a level, mm; 0: a share of the diameter"));
    preset.option("--coolant", arguments->coolant, BURIN_TEXT("Help", "Coolant, or what the material advises"))
        .choices({"advised", "off", "mist", "flood"});
    preset.flag("--first", arguments->first, BURIN_TEXT("Help", "Prefer it to the tool's other presets"));
    preset.flag("--remove", arguments->remove, BURIN_TEXT("Help", "Delete the preset"));
    preset.run([arguments, &context, &status] { status = changePresets(*arguments, context); });
}

} // namespace burin
