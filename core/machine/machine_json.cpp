// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/degrees.h"
#include "core/machine/machine_library.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

namespace burin {

namespace {

using nlohmann::ordered_json;

constexpr std::array rapidNames{"synchronised", "independent", "tip"};  // in the order of RapidMode
constexpr std::array junctionNames{"exact_stop", "deviation", "blend"}; // in the order of JunctionRule

ordered_json jsonOf(const glm::dvec3& axes) {
    return ordered_json::array({axes.x, axes.y, axes.z});
}

/// The values of each axis; nothing is written if no axis has a value of its own.
void addAxes(ordered_json& file, const char* key, const glm::dvec3& axes) {
    if (axes != glm::dvec3(0.0)) file[key] = jsonOf(axes);
}

void addIfStated(ordered_json& file, const char* key, double value) {
    if (value > 0.0) file[key] = value;
}

void addMotion(ordered_json& file, const MachineProfile& machine) {
    file["travel_mm"] = jsonOf(machine.travel);
    file["maximum_feed_mm_per_min"] = machine.maximumFeed;
    file["rapid_feed_mm_per_min"] = machine.rapidFeed;
    addAxes(file, "axis_rates_mm_per_min", machine.axisRates);
    file["acceleration_mm_per_s2"] = machine.acceleration;
    addAxes(file, "axis_accelerations_mm_per_s2", machine.axisAccelerations);
    addAxes(file, "axis_jerks_mm_per_s3", machine.axisJerks);
    addIfStated(file, "blocks_per_second", machine.blocksPerSecond);
    file["rapids"] = rapidNames[static_cast<std::size_t>(machine.rapids)];
    file["junctions"] = {{"rule", junctionNames[static_cast<std::size_t>(machine.junctions)]},
                         {"tolerance_mm", machine.junctionTolerance}};
}

void addSpindle(ordered_json& file, const MachineProfile& machine) {
    file["minimum_spindle_speed_rpm"] = machine.minimumSpindleSpeed;
    file["maximum_spindle_speed_rpm"] = machine.maximumSpindleSpeed;
    addIfStated(file, "spindle_power_w", machine.spindlePower);
    for (const SpindlePoint& point : machine.spindleTorque)
        file["spindle_torque"].push_back({{"speed_rpm", point.speed}, {"torque_nm", point.torque}});
}

void addArcs(ordered_json& file, const ArcRules& rules) {
    file["arcs"] = {{"largest_sweep_deg", roundedDegrees(rules.largestSweep)},
                    {"smallest_radius_mm", rules.smallestRadius},
                    {"largest_radius_mm", rules.largestRadius},
                    {"radius_mismatch_mm", rules.radiusMismatch}};
}

void addRotaryAxes(ordered_json& file, const MachineProfile& machine) {
    for (const RotaryAxis& axis : machine.rotaryAxes) {
        ordered_json entry{{"axis", std::string(1, letterOf(axis.axis))}};
        if (axis.reversed) entry["reversed"] = true;
        if (std::isfinite(axis.low)) entry["low_deg"] = axis.low;
        if (std::isfinite(axis.high)) entry["high_deg"] = axis.high;
        addIfStated(entry, "rate_deg_per_min", axis.rate);
        addIfStated(entry, "acceleration_deg_per_s2", axis.acceleration);
        file["rotary_axes"].push_back(std::move(entry));
    }
}

void addCoolants(ordered_json& file, const MachineProfile& machine) {
    if (!machine.coolants) return;
    for (const Coolant each : {Coolant::mist, Coolant::flood}) file["coolant"][idOf(each)] = machine.has(each);
}

} // namespace

std::string toJson(const MachineProfile& machine) {
    ordered_json file{{"id", machine.id}, {"name", machine.name}, {"source", machine.source}};
    // reserves the position in the file; filled at the end from the keys that the file states
    file["sources"] = ordered_json::object();
    if (!machine.dialect.empty()) file["dialect"] = machine.dialect;
    addMotion(file, machine);
    addSpindle(file, machine);
    file["tool_change_height_mm"] = machine.toolChangeHeight;
    addIfStated(file, "tool_change_s", machine.toolChangeSeconds);
    if (machine.home) file["home_mm"] = jsonOf(*machine.home);
    addRotaryAxes(file, machine);
    addArcs(file, machine.arcs);
    addCoolants(file, machine);
    file["coordinate_decimals"] = machine.coordinateDecimals;
    file["maximum_line_length"] = machine.maximumLineLength;
    for (const auto& [key, source] : machine.sources)
        if (file.contains(key)) file["sources"][key] = source;
    if (file["sources"].empty()) file.erase("sources");
    // Invalid UTF-8 is replaced: an exception must not leave this library.
    return file.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

} // namespace burin
