// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The presets of a tool in Fusion's library: "start-values.presets". Lengths and feeds are in the unit of the tool.
#include "core/base/clean_text.h"
#include "core/tool/foreign_tool.h"

#include <algorithm>
#include <array>

namespace burin {

namespace {

using nlohmann::json;

/// Names of what Burin's presets don't have.
constexpr std::array ownOfFusion{"n_ramp",         "v_f_ramp",    "v_f_leadIn", "v_f_leadOut",
                                 "v_f_transition", "v_f_retract", "ramp-angle"};

/// A preset as it was read, with the name of its material.
class FusionPreset {
public:
    FusionPreset(const json& preset, double unit) : json_(preset), unit_(unit) {}

    CuttingPreset preset() const {
        CuttingPreset read;
        read.name = textIn(json_, "name");
        read.spindleSpeed = numberIn(json_, "n");
        read.feed = length("v_f");
        if (!(read.feed > 0.0)) read.chipLoad = length("f_z");
        if (!(read.feed > 0.0) && !(read.chipLoad > 0.0)) read.feed = length("f_n") * read.spindleSpeed;
        read.plungeFeed = length("v_f_plunge");
        read.stepDown = step("stepdown", "use-stepdown");
        read.stepOver = step("stepover", "use-stepover");
        const std::string coolant = textIn(json_, "tool-coolant");
        if (coolant == "disabled") read.coolant = Coolant::off;
        if (coolant == "mist") read.coolant = Coolant::mist;
        if (coolant == "flood") read.coolant = Coolant::flood;
        return read;
    }
    /// Fusion searches for the query; the category "all" means any material.
    std::string material() const {
        const auto found = json_.find("material");
        if (found == json_.end() || !found->is_object()) return {};
        if (const std::string query = textIn(*found, "query"); !query.empty()) return query;
        const std::string category = textIn(*found, "category");
        return category == "all" ? std::string() : category;
    }

private:
    double length(const char* key) const { return unit_ * numberIn(json_, key); }
    double step(const char* key, const char* use) const {
        const auto used = json_.find(use);
        return used != json_.end() && used->is_boolean() && !used->get<bool>() ? 0.0 : length(key);
    }

    const json& json_;
    double unit_; ///< mm
};

} // namespace

void readFusionPresets(const json& item, double unit, ReadTool& read) {
    const auto start = item.find("start-values");
    if (start == item.end() || !start->is_object()) return;
    const auto presets = start->find("presets");
    if (presets == start->end() || !presets->is_array()) return;
    bool more = false;
    for (const json& each : *presets) {
        if (!each.is_object()) continue;
        const FusionPreset foreign(each, unit);
        const CuttingPreset preset = foreign.preset();
        if (const std::string coolant = textIn(each, "tool-coolant"); !preset.coolant && !coolant.empty())
            read.notes.push_back("Coolant \"" + cleanLine(coolant) + "\" of a preset was not imported.");
        more = more || std::ranges::any_of(ownOfFusion, [&each](const char* key) { return each.contains(key); });
        addForeignPreset(preset, foreign.material(), read);
    }
    if (more) read.notes.emplace_back("Feeds of presets for ramps, leads and transitions were not imported.");
}

json fusionPresets(const Tool& tool) {
    json list = json::array();
    for (const CuttingPreset& preset : tool.presets) {
        const double feed = feedOf(preset, tool.fluteCount);
        json entry{{"name", preset.name},
                   {"material", {{"category", "all"}, {"query", preset.material}, {"use-hardness", false}}},
                   {"n", preset.spindleSpeed},
                   {"v_c", surfaceSpeedOf(preset.spindleSpeed, tool.cutter.diameter)},
                   {"v_f", feed},
                   {"f_n", feed / preset.spindleSpeed},
                   {"f_z", feed / (preset.spindleSpeed * tool.fluteCount)},
                   {"use-stepdown", preset.stepDown > 0.0},
                   {"use-stepover", preset.stepOver > 0.0}};
        if (preset.plungeFeed > 0.0) entry["v_f_plunge"] = preset.plungeFeed;
        if (preset.stepDown > 0.0) entry["stepdown"] = preset.stepDown;
        if (preset.stepOver > 0.0) entry["stepover"] = preset.stepOver;
        if (preset.coolant)
            entry["tool-coolant"] = *preset.coolant == Coolant::off ? "disabled" : idOf(*preset.coolant);
        list.push_back(std::move(entry));
    }
    return list;
}

} // namespace burin
