// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/device/device_registry.h"
#include "core/device/device_trial.h"
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

/// Drivers that have no devices because a library of their maker's is missing.
void addDrivers(DeviceRegistry& registry, json& answer, std::string& text) {
    for (const DriverState& driver : registry.drivers()) {
        json entry{{"id", driver.id}, {"name", driver.name}, {"ready", !driver.missing.has_value()}};
        if (driver.missing) {
            const std::string sentence = Messages::sentence(*driver.missing).toStdString();
            entry["fault"] = sentence;
            text += "\n" + driver.id + ": " + sentence;
        }
        answer["drivers"].push_back(entry);
    }
}

/// What --test asks for.
struct TrialArguments {
    std::string device, mode;
    TrialSettings settings;
};

json jsonOf(const glm::dvec3& place) {
    return {place.x, place.y, place.z};
}

json jsonOf(const TrialFigures& figures) {
    json faults = json::array();
    for (const Error& fault : figures.faults) faults.push_back(Messages::sentence(fault).toStdString());
    return {{"seconds", figures.seconds},
            {"readings", figures.readings},
            {"readings_invalid", figures.invalid},
            {"rate_hz", figures.rate},
            {"interval_median_s", figures.medianInterval},
            {"interval_max_s", figures.maximumInterval},
            {"step_min_mm", figures.smallestStep},
            {"rotation_max_rad", figures.maximumRotation},
            {"position_min_mm", jsonOf(figures.lowest)},
            {"position_max_mm", jsonOf(figures.highest)},
            {"buttons_pressed", figures.buttons},
            {"force_max_n", figures.maximumForce},
            {"health", jsonOf(figures.health)},
            {"faults", faults}};
}

std::string textOf(const TrialFigures& figures) {
    const auto rounded = [](double value, int digits) { return formatFixed(value, digits); };
    std::string text =
        worded(BURIN_TEXT("Command", "%1 readings in %2 s: %3 Hz; interval: median %4 ms, maximum %5 ms"),
               {std::to_string(figures.readings), rounded(figures.seconds, 2), rounded(figures.rate, 1),
                rounded(1e3 * figures.medianInterval, 2), rounded(1e3 * figures.maximumInterval, 2)});
    const glm::dvec3 span = figures.highest - figures.lowest;
    text += "\n" + worded(BURIN_TEXT("Command", "motion %1 × %2 × %3 mm, smallest step %4 mm, rotation %5°"),
                          {rounded(span.x, 1), rounded(span.y, 1), rounded(span.z, 1), rounded(figures.smallestStep, 4),
                           rounded(glm::degrees(figures.maximumRotation), 0)});
    std::string pressed;
    for (unsigned int i = 0; i < 32; ++i)
        if ((figures.buttons >> i & 1U) != 0) pressed += (pressed.empty() ? "" : ", ") + std::to_string(i + 1);
    text += "\n" + (pressed.empty() ? worded(BURIN_TEXT("Command", "no button was pressed"))
                                    : worded(BURIN_TEXT("Command", "buttons pressed: %1"), {pressed}));
    text += "\n" + worded(BURIN_TEXT("Command", "maximum force %1 N"), {rounded(figures.maximumForce, 2)});
    if (figures.invalid > 0)
        text += "\n" + worded(BURIN_TEXT("Command", "%1 readings were not valid"), {std::to_string(figures.invalid)});
    for (const Error& fault : figures.faults) text += "\n" + Messages::sentence(fault).toStdString();
    return text;
}

/// Tests one device; status 1 if it had faults or gave no valid reading.
int runTrial(CommandContext& context, const TrialArguments& arguments) {
    DeviceRegistry registry;
    const bool simulated = arguments.device == simulatedDevice;
    const Result<FoundDevice> device =
        simulated ? Result<FoundDevice>(FoundDevice{simulatedDevice, {}, {}}) : registry.find(arguments.device);
    if (!device) return context.fail(device.error());
    const Result<AnyStylus> stylus = registry.make(device->id, arguments.mode);
    if (!stylus) return context.fail(stylus.error());
    context.stage(BURIN_TEXT("Command", "Testing the device"));
    const Result<TrialFigures> figures = tryDevice(StylusHandle(*stylus), arguments.settings, context.progress());
    if (!figures) return context.fail(figures.error());
    context.answer({{"device", device->id}, {"test", jsonOf(*figures)}}, textOf(*figures));
    return figures->faults.empty() && figures->readings > 0 ? 0 : 1;
}

int runDevices(CommandContext& context) {
    DeviceRegistry registry;
    json answer{{"devices", json::array()}, {"drivers", json::array()}, {"faults", json::array()}};
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
    addDrivers(registry, answer, text);
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
    const auto arguments = std::make_shared<TrialArguments>();
    const Argument test = command.option(
        "--test", arguments->device,
        BURIN_TEXT("Help", "Test this device: reads it and reports rate, intervals, motion and buttons"));
    command.option("--mode", arguments->mode, BURIN_TEXT("Help", "One of the device's modes")).needs(test);
    command.option("--seconds", arguments->settings.seconds, BURIN_TEXT("Help", "Duration, s"))
        .range(0.1, 3600.0)
        .showDefault()
        .needs(test);
    command
        .option("--force", arguments->settings.force,
                BURIN_TEXT("Help", "Push up with this force, N, while its first button is held; at most a fifth of "
                                   "its maximum force"))
        .range(0.0, 100.0)
        .needs(test);
    command.run([&context, &status, arguments] {
        status = arguments->device.empty() ? runDevices(context) : runTrial(context, *arguments);
    });
}

} // namespace burin
