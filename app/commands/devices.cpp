// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "core/base/numbers.h"
#include "core/device/device_registry.h"
#include "core/device/stylus_handle.h"
#include "ui/messages/messages.h"

#include <CLI/CLI.hpp>

#include <array>

namespace burin {

namespace {

using nlohmann::json;

/// A figure of a description, as people and JSON name it.
struct Limit {
    std::string name; ///< of JSON, with its unit
    std::string label, unit;
    double value;
    std::string source;
};

template <UnitName unit>
Limit limit(const char* name, const char* label, const Figure<unit>& figure) {
    return {name, label, std::string(Figure<unit>::unit), figure.value, figure.source};
}

std::vector<Limit> limitsOf(const StylusDescription& stylus) {
    return {limit("rate_hz", "rate", stylus.rate),
            limit("delay_s", "delay", stylus.delay),
            limit("force_max_n", "greatest force", stylus.maximumForce),
            limit("force_continuous_n", "continuous force", stylus.continuousForce),
            limit("torque_max_n_mm", "greatest torque", stylus.maximumTorque),
            limit("stiffness_max_n_per_m", "greatest stiffness", stylus.maximumStiffness),
            limit("damping_max_n_s_per_m", "greatest damping", stylus.maximumDamping),
            limit("turning_stiffness_max_n_mm_per_rad", "greatest turning stiffness", stylus.maximumTurningStiffness),
            limit("workspace_radius_mm", "workspace radius", stylus.workspaceRadius),
            limit("position_step_mm", "position step", stylus.positionStep),
            limit("rotation_step_rad", "rotation step", stylus.rotationStep),
            limit("speed_max_mm_per_s", "greatest speed", stylus.maximumSpeed),
            limit("handle_mass_kg", "handle's mass", stylus.handleMass)};
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
        text += "\n  mode " + mode.id + ": " + Messages::text(mode.name).toStdString();
    for (const Limit& limit : limitsOf(stylus))
        if (limit.value > 0.0)
            text +=
                "\n  " + limit.label + " " + formatShortest(limit.value) + " " + limit.unit + " (" + limit.source + ")";
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

void registerDevices(CLI::App& program, CommandContext& context, int& status) {
    CLI::App* command = program.add_subcommand("devices", "List the styluses that are plugged in, and their limits");
    addJsonFlag(*command, context);
    command->callback([&context, &status] { status = runDevices(context); });
}

} // namespace burin
