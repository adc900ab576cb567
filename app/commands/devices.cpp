// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"
#include "app/commands/device_axes.h"
#include "app/commands/device_gains.h"
#include "app/wording.h"
#include "core/device/device_registry.h"
#include "core/device/device_trial.h"
#include "core/device/stylus_handle.h"
#include "ui/messages/messages.h"
#include "ui/panels/device_labels.h"

#include <QLocale>

namespace burin {

namespace {

using nlohmann::json;

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
    for (const DeviceLimit& limit : limitsOf(stylus))
        limits[limit.name] = {{"value", limit.value}, {"unit", limit.unit}, {"source", limit.source}};
    return {{"translations_sensed", stylus.sensed.translations},
            {"rotations_sensed", stylus.sensed.rotations},
            {"translations_driven", stylus.actuated.translations},
            {"rotations_driven", stylus.actuated.rotations},
            {"buttons", stylus.buttons},
            {"assist",
             {{"rumble", stylus.assist.rumble},
              {"force_axes", stylus.assist.forceAxes},
              {"permitted", stylus.assist.permitted}}},
            {"simulated", stylus.simulated},
            {"limits", limits}};
}

std::string textOf(const FoundDevice& device, const StylusDescription& stylus) {
    std::string text = device.id + ": " + device.name;
    for (const DeviceMode& mode : device.modes)
        text += "\n  " + worded(BURIN_TEXT("Command", "mode %1: %2"), {mode.id, worded(mode.name)});
    for (const QString& line : limitLines(stylus, QLocale::c())) text += "\n  " + line.toStdString();
    return text;
}

/// Reports drivers that have no devices because a library of the vendor is missing.
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

/// The arguments of --test.
struct TrialArguments {
    std::string device, mode;
    TrialSettings settings;
    GainArguments gains;
};

json jsonOf(const glm::dvec3& vector) {
    return {vector.x, vector.y, vector.z};
}

json jsonOf(const TrialFigures& figures) {
    json faults = json::array();
    for (const Error& fault : figures.faults) faults.push_back(Messages::sentence(fault).toStdString());
    return {{"seconds", figures.seconds},
            {"readings", figures.readings},
            {"readings_invalid", figures.invalid},
            {"rate_hz", figures.rate},
            {"interval_median_s", figures.medianInterval},
            {"interval_p99_s", figures.usualInterval},
            {"latency_max_s", figures.latency > 0.0 ? json(figures.latency) : json(nullptr)},
            {"interval_max_s", figures.maximumInterval},
            {"step_min_mm", figures.smallestStep},
            {"rotation_max_rad", figures.maximumRotation},
            {"position_min_mm", jsonOf(figures.lowest)},
            {"position_max_mm", jsonOf(figures.highest)},
            {"buttons_pressed", figures.buttons},
            {"force_max_n", figures.maximumForce},
            {"assist_max", figures.maximumAssist},
            {"health", jsonOf(figures.health)},
            {"faults", faults}};
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
    json answer{{"device", device->id}, {"test", jsonOf(*figures)}};
    std::string text = trialLines(*figures, QLocale::c()).join(QLatin1Char('\n')).toStdString();
    const Result<void> kept =
        answerGains(device->id, StylusHandle(*stylus).device().description(), *figures, arguments.gains, answer, text);
    if (!kept) return context.fail(kept.error());
    context.answer(answer, text);
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
            for (const DeviceAxis& axis : made.axes()) entry["axes"].push_back(axis.name);
            line(textOf(device, made.description()));
        } else { // present but unusable: reports why
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
    command
        .option("--assist", arguments->settings.assist,
                BURIN_TEXT("Help", "Let a gamepad vibrate or a joystick push while its first button is held: the "
                                   "strength rises to this share of its strongest effect within each second, 0 to 1"))
        .range(0.0, 1.0)
        .needs(test);
    addGainOptions(command, arguments->gains, test);
    const auto axes = std::make_shared<AxesArguments>();
    addAxesOptions(command, *axes, test);
    command.run([&context, &status, arguments, axes] {
        status = !axes->mapped.empty()                ? mapAxes(*axes, context)
                 : !axes->calibrated.empty()          ? calibrateAxes(*axes, context)
                 : !arguments->gains.restored.empty() ? restoreGains(arguments->gains, context)
                 : arguments->device.empty()          ? runDevices(context)
                                                      : runTrial(context, *arguments);
    });
}

} // namespace burin
