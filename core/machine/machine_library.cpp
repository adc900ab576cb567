// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/machine/machine_library.h"

#include "core/base/json_object.h"
#include "core/base/resource_folder.h"
#include "core/machine/machine_ranges.h"

#include <cmath>

namespace burin {

namespace {

using namespace machine_range;

glm::dvec3 axesOf(JsonObject& file, std::string_view key, NumberRange range) {
    const std::vector<double> axes = file.numbers(key, 3, range);
    return {axes[0], axes[1], axes[2]};
}

glm::dvec3 axesOr(JsonObject& file, std::string_view key, NumberRange range) {
    return file.has(key) ? axesOf(file, key, range) : glm::dvec3(0.0);
}

void readMotion(JsonObject& file, MachineProfile& machine) {
    machine.maximumFeed = file.number("maximum_feed_mm_per_min", feed);
    machine.rapidFeed = file.number("rapid_feed_mm_per_min", feed);
    machine.axisRates = axesOr(file, "axis_rates_mm_per_min", feed);
    machine.acceleration = file.number("acceleration_mm_per_s2", acceleration);
    machine.axisAccelerations = axesOr(file, "axis_accelerations_mm_per_s2", acceleration);
    machine.axisJerks = axesOr(file, "axis_jerks_mm_per_s3", jerk);
    if (file.has("blocks_per_second")) machine.blocksPerSecond = file.number("blocks_per_second", blockRate);
    if (file.has("rapids"))
        machine.rapids = static_cast<RapidMode>(file.choice("rapids", {"synchronised", "independent", "tip"}));
    if (file.has("junctions"))
        file.object("junctions", [&](JsonObject& junctions) {
            machine.junctions =
                static_cast<JunctionRule>(junctions.choice("rule", {"exact_stop", "deviation", "blend"}));
            machine.junctionTolerance = junctions.numberOr("tolerance_mm", 0.0, tolerance);
            if (machine.junctions != JunctionRule::exactStop && !(machine.junctionTolerance > 0.0))
                junctions.fail("tolerance_mm", "has to be above 0 with this rule");
        });
}

void readArcs(JsonObject& file, ArcRules& rules) {
    if (!file.has("arcs")) return;
    file.object("arcs", [&](JsonObject& arcs) {
        rules.largestSweep = arcs.number("largest_sweep_deg", sweep) * pi / 180.0;
        rules.smallestRadius = arcs.number("smallest_radius_mm", radius);
        rules.largestRadius = arcs.number("largest_radius_mm", radius);
        rules.radiusMismatch = arcs.number("radius_mismatch_mm", tolerance);
        if (rules.smallestRadius >= rules.largestRadius)
            arcs.fail("smallest_radius_mm", "has to be below largest_radius_mm");
    });
}

void readTorque(JsonObject& file, std::vector<SpindlePoint>& torque) {
    if (!file.has("spindle_torque")) return;
    file.objects("spindle_torque", [&](JsonObject& entry) {
        const SpindlePoint point{entry.number("speed_rpm", spindleSpeed), entry.number("torque_nm", spindleTorque)};
        if (!(point.speed > (torque.empty() ? 0.0 : torque.back().speed)))
            entry.fail("speed_rpm", "has to be above 0 and above the one before");
        torque.push_back(point);
    });
    if (torque.empty()) file.fail("spindle_torque", "has to hold a point at least");
}

void readSpindle(JsonObject& file, MachineProfile& machine) {
    machine.minimumSpindleSpeed = file.number("minimum_spindle_speed_rpm", spindleSpeed);
    machine.maximumSpindleSpeed = file.number("maximum_spindle_speed_rpm", spindleSpeed);
    if (!(machine.maximumSpindleSpeed > 0.0)) file.fail("maximum_spindle_speed_rpm", "has to be above 0");
    if (machine.minimumSpindleSpeed > machine.maximumSpindleSpeed)
        file.fail("minimum_spindle_speed_rpm", "has to be at most maximum_spindle_speed_rpm");
    if (file.has("spindle_power_w")) machine.spindlePower = file.number("spindle_power_w", spindlePower);
    readTorque(file, machine.spindleTorque);
}

void readCoolants(JsonObject& file, MachineProfile& machine) {
    if (!file.has("coolant")) return;
    machine.coolants.emplace();
    file.object("coolant", [&](JsonObject& coolant) {
        for (const Coolant each : {Coolant::mist, Coolant::flood})
            if (coolant.boolean(idOf(each))) machine.coolants->push_back(each);
    });
}

/// The second of two axes has to tilt the tool, and so has a single one: that is A or B, about X or Y.
void readRotaryAxes(JsonObject& file, MachineProfile& machine) {
    if (!file.has("rotary_axes")) return;
    file.objects("rotary_axes", [&](JsonObject& entry) {
        RotaryAxis axis;
        axis.axis = static_cast<Axis>(static_cast<int>(Axis::a) + entry.choice("axis", {"A", "B", "C"}));
        if (entry.has("reversed")) axis.reversed = entry.boolean("reversed");
        if (entry.has("low_deg")) axis.low = entry.number("low_deg", rotaryAngle);
        if (entry.has("high_deg")) axis.high = entry.number("high_deg", rotaryAngle);
        axis.rate = entry.has("rate_deg_per_min") ? entry.number("rate_deg_per_min", rotaryRate) : 0.0;
        if (entry.has("acceleration_deg_per_s2"))
            axis.acceleration = entry.number("acceleration_deg_per_s2", rotaryAcceleration);
        if (!(axis.low < axis.high)) entry.fail("high_deg", "has to be above low_deg");
        if (axis.low > 0.0 || axis.high < 0.0) entry.fail("low_deg", "has to leave 0 within the limits");
        machine.rotaryAxes.push_back(axis);
    });
    const std::vector<RotaryAxis>& axes = machine.rotaryAxes;
    const bool sound = !axes.empty() && axes.size() <= 2 && axes.back().axis != Axis::c &&
                       (axes.size() == 1 || axes.front().axis != axes.back().axis);
    if (!sound) file.fail("rotary_axes", "has to be A or B, or two different axes of which A or B is the second");
}

/// A source for a key that the file does not have is a typing error.
void readSources(JsonObject& file, MachineProfile& machine) {
    machine.source = file.text("source");
    if (!file.has("sources")) return;
    machine.sources = file.textsByName("sources");
    for (const auto& [key, source] : machine.sources)
        if (!file.has(key)) file.fail("sources." + key, "names no key of this file");
}

/// Checks rules that involve several keys.
void checkTogether(JsonObject& file, const MachineProfile& machine) {
    for (int axis = 0; axis < 3; ++axis)
        if (machine.axisRates[axis] > machine.rapidFeed)
            file.fail("axis_rates_mm_per_min[" + std::to_string(axis) + "]",
                      "has to be at most rapid_feed_mm_per_min, the greatest feed of all");
    if (machine.tilts() && machine.rapids == RapidMode::independent)
        file.fail("rapids", "has to be synchronised or tip with rotary_axes");
    if (machine.toolChangeHeight >= machine.travel.z)
        file.fail("tool_change_height_mm", "has to be below the travel of Z");
    for (int axis = 0; machine.home && axis < 3; ++axis) // at whichever end of the travel its zero is
        if (std::abs((*machine.home)[axis]) > machine.travel[axis])
            file.fail("home_mm[" + std::to_string(axis) + "]",
                      "has to be at most travel_mm[" + std::to_string(axis) + "] from the machine's zero");
}

} // namespace

Result<MachineProfile> machineFromJson(std::string_view text, const std::string& origin) {
    Result<JsonObject> file = JsonObject::parse(text, origin);
    if (!file) return file.error();
    MachineProfile machine;
    machine.id = file->text("id");
    machine.name = file->text("name");
    if (file->has("dialect")) machine.dialect = file->text("dialect");
    machine.travel = axesOf(*file, "travel_mm", travel);
    readMotion(*file, machine);
    readSpindle(*file, machine);
    readArcs(*file, machine.arcs);
    readCoolants(*file, machine);
    readRotaryAxes(*file, machine);
    machine.toolChangeHeight = file->number("tool_change_height_mm", height);
    machine.toolChangeSeconds = file->numberOr("tool_change_s", 0.0, toolChange);
    if (file->has("home_mm")) machine.home = axesOf(*file, "home_mm", home);
    machine.coordinateDecimals = file->integer("coordinate_decimals", fewestDecimals, mostDecimals);
    machine.maximumLineLength = file->integer("maximum_line_length", shortestLine, longestLine);
    readSources(*file, machine);
    checkTogether(*file, machine);
    if (Result<void> read = file->finish(); !read) return read.error();
    return machine;
}

Result<MachineProfile> loadMachine(std::string_view id) {
    Result<ResourceText> file = findResource(machineResource, id);
    if (!file) return file.error();
    Result<MachineProfile> machine = machineFromJson(file->text, file->file);
    if (machine && machine->id != id)
        return Error{ErrorCode::resourceInvalid, file->file, "id", "has to be the file's name"};
    return machine;
}

std::vector<std::string> machineIds() {
    return resourceIds(machineResource);
}

MachineProfile copyOf(const MachineProfile& machine, const std::string& id, const std::string& name) {
    MachineProfile copy = machine;
    copy.id = id;
    copy.name = name;
    copy.source = "copy of " + machine.id + ": " + machine.source;
    return copy;
}

bool isTypicalMachine(std::string_view id) {
    return isShipped(machineResource, id) && !isOfUser(machineResource, id);
}

Result<std::filesystem::path> saveMachine(const MachineProfile& machine, bool replace) {
    Result<std::filesystem::path> file = userResourceFile(machineResource, machine.id);
    if (!file) return file;
    if (isShipped(machineResource, machine.id))
        return Error{ErrorCode::argumentInvalid, "machine", machine.id,
                     "an id that no shipped machine has; shipped machines can be copied, not changed"};
    if (!replace && isOfUser(machineResource, machine.id))
        return Error{ErrorCode::argumentInvalid, "machine", machine.id, "an id that no machine has yet, or --replace"};
    const std::string text = toJson(machine);
    if (const Result<MachineProfile> sound = machineFromJson(text, file->filename().string()); !sound)
        return sound.error();
    return saveUserResource(machineResource, machine.id, text);
}

Result<void> removeMachine(const std::string& id) {
    if (isTypicalMachine(id))
        return Error{ErrorCode::argumentInvalid, "machine", id,
                     "a machine of your own; those that Burin is shipped with can't be deleted"};
    return removeUserResource(machineResource, id);
}

} // namespace burin
