// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/machine/machine_library.h"

#include "core/base/json_object.h"
#include "core/base/resource_folder.h"

namespace burin {

namespace {

// Wide enough for any milling machine, narrow enough to catch a slip of the unit.
constexpr NumberRange travel{1.0, 1e5};
constexpr NumberRange feed{1.0, 1e6};
constexpr NumberRange spindleSpeed{0.0, 1e6};
constexpr NumberRange acceleration{1.0, 1e6};
constexpr NumberRange height{0.0, 1e4};

} // namespace

Result<MachineProfile> machineFromJson(std::string_view text, const std::string& origin) {
    Result<JsonObject> file = JsonObject::parse(text, origin);
    if (!file) return file.error();
    MachineProfile machine;
    machine.id = file->text("id");
    machine.name = file->text("name");
    machine.source = file->text("source");
    const std::vector<double> axes = file->numbers("travel_mm", 3, travel);
    machine.travel = {axes[0], axes[1], axes[2]};
    machine.maximumFeed = file->number("maximum_feed_mm_per_min", feed);
    machine.rapidFeed = file->number("rapid_feed_mm_per_min", feed);
    machine.minimumSpindleSpeed = file->number("minimum_spindle_speed_rpm", spindleSpeed);
    machine.maximumSpindleSpeed = file->number("maximum_spindle_speed_rpm", spindleSpeed);
    machine.acceleration = file->number("acceleration_mm_per_s2", acceleration);
    machine.toolChangeHeight = file->number("tool_change_height_mm", height);
    machine.coordinateDecimals = file->integer("coordinate_decimals", 0, 9);
    machine.maximumLineLength = file->integer("maximum_line_length", 20, 100000);
    if (!(machine.maximumSpindleSpeed > 0.0)) file->fail("maximum_spindle_speed_rpm", "has to be above 0");
    if (machine.minimumSpindleSpeed > machine.maximumSpindleSpeed)
        file->fail("minimum_spindle_speed_rpm", "has to be at most maximum_spindle_speed_rpm");
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

} // namespace burin
