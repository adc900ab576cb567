// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/device/device_registry.h"
#include "core/device/stylus_handle.h"
#include "ui/messages/messages.h"

#include <array>

namespace burin {

namespace {

using nlohmann::json;

/// A value of a description, as people and JSON name it.
struct Limit {
    std::string name; ///< of JSON, with its unit
    TextId label;
    std::string unit;
    double value;
    std::string source;
};

template <UnitName unit>
Limit limit(const char* name, TextId label, const Figure<unit>& figure) {
    return {name, label, std::string(Figure<unit>::unit), figure.value, figure.source};
}

std::vector<Limit> limitsOf(const StylusDescription& stylus) {
    return {limit("rate_hz", BURIN_TEXT("Command", "rate"), stylus.rate),
            limit("delay_s", BURIN_TEXT("Command", "delay"), stylus.delay),
            limit("force_max_n", BURIN_TEXT("Command", "maximum force"), stylus.maximumForce),
            limit("force_continuous_n", BURIN_TEXT("Command", "continuous force"), stylus.continuousForce),
            limit("torque_max_n_mm", BURIN_TEXT("Command", "maximum torque"), stylus.maximumTorque),
            limit("stiffness_max_n_per_m", BURIN_TEXT("Command", "maximum stiffness"), stylus.maximumStiffness),
            limit("damping_max_n_s_per_m", BURIN_TEXT("Command", "maximum damping"), stylus.maximumDamping),
            limit("turning_stiffness_max_n_mm_per_rad", BURIN_TEXT("Command", "maximum rotational stiffness"),
                  stylus.maximumTurningStiffness),
            limit("workspace_radius_mm", BURIN_TEXT("Command", "workspace radius"), stylus.workspaceRadius),
            limit("position_step_mm", BURIN_TEXT("Command", "position step"), stylus.positionStep),
            limit("rotation_step_rad", BURIN_TEXT("Command", "rotation step"), stylus.rotationStep),
            limit("speed_max_mm_per_s", BURIN_TEXT("Command", "maximum speed"), stylus.maximumSpeed),
            limit("handle_mass_kg", BURIN_TEXT("Command", "mass of the handle"), stylus.handleMass)};
}

json jsonOf(const DeviceHealth& health) {
    return {{"connected", health.connected},
            {"readings", health.readings},
            {"lost", health.lost},
            {"damaged", health.damaged},
            {"motor_heat", health.motorHeat ? json(*health.motorHeat) : json(nullptr)},
            {"battery", health.batteryShare ? json(*health.batteryShare) : json(nullptr)},
            {"charging", health.charging}};
}

json jsonOf(const FoundDevice& device) {
    json modes = json::array();
    for (const DeviceMode& mode : device.modes)
        modes.push_back({{"id", mode.id}, {"name", Messages::text(mode.name).toStdString()}});
    return {{"id", device.id}, {"name", device.name}, {"modes", modes}};
}

json jsonOf(const StylusDescription& stylus) {
    json limits = json::object();
    for (const Limit& limit : limitsOf(stylus))
        if (limit.value > 0.0)
            limits[limit.name] = {{"value", limit.value}, {"unit", limit.unit}, {"source", limit.source}};
    return {{"translations_sensed", stylus.sensed.translations},
            {"rotations_sensed", stylus.sensed.rotations},
            {"translations_driven", stylus.actuated.translations},
            {"rotations_driven", stylus.actuated.rotations},
            {"buttons", stylus.buttons},
            {"simulated", stylus.simulated},
            {"limits", limits}};
}

std::string textOf(const FoundDevice& device, const StylusDescription& stylus) {
    std::string text = device.id + ": " + device.name;
    for (const DeviceMode& mode : device.modes)
        text += "\n  " + worded(BURIN_TEXT("Command", "mode %1: %2"), {mode.id, worded(mode.name)});
    for (const Limit& limit : limitsOf(stylus))
        if (limit.value > 0.0)
            text += "\n  " + worded(limit.label) + " " + formatShortest(limit.value) + " " + limit.unit + " (" +
                    worded({"Device", limit.source.c_str()}) + ")";
    return text;
}

int runDevices(CommandContext& context) {
    DeviceRegistry registry;
    json answer{{"devices", json::array()}, {"faults", json::array()}};
    std::string text;
    const auto line = [&text](const std::string& more) { text += (text.empty() ? "" : "\n") + more; };
    for (const FoundDevice& device : registry.scan()) {
        json entry = jsonOf(device);
        const Result<AnyStylus> stylus = registry.make(device.id);
        if (stylus) {
            const StylusDevice& made = StylusHandle(*stylus).device();
            entry.update(jsonOf(made.description()));
            entry["self_paced"] = StylusHandle(*stylus).selfPaced() != nullptr;
            entry["health"] = jsonOf(made.health());
            line(textOf(device, made.description()));
        } else { // there, but not to be used: that is what is to be known of it
            entry["fault"] = Messages::sentence(stylus.error()).toStdString();
            line(device.id + ": " + device.name + "\n  " + Messages::sentence(stylus.error()).toStdString());
        }
        answer["devices"].push_back(entry);
    }
    for (const Error& fault : registry.takeFaults()) {
        answer["faults"].push_back(Messages::sentence(fault).toStdString());
        context.message(Messages::sentence(fault).toStdString());
    }
    context.answer(answer, text);
    return 0;
}

} // namespace

void registerDevices(CommandParser program, CommandContext& context, int& status) {
    const CommandParser command =
        program.command("devices", BURIN_TEXT("Help", "List the styluses that are plugged in, and their limits"));
    addJsonFlag(command, context);
    command.run([&context, &status] { status = runDevices(context); });
}

} // namespace burin
