// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/commands/device_axes.h"

#include "app/number_list.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/device/axis_calibration.h"
#include "core/device/axis_map_json.h"
#include "core/device/device_registry.h"
#include "ui/dialogs/preferences.h"
#include "ui/panels/device_labels.h"

#include <QLocale>

#include <optional>
#include <utility>

namespace burin {

namespace {

using nlohmann::json;

/// A device with axes, connected, and the map that the user keeps for it.
struct ConnectedAxes {
    FoundDevice found;
    AnyStylus stylus;
    MappableDevice mappable;
    AxisMap map;

    StylusHandle handle() const { return {stylus}; }
};

/// @param ignoreKept for a kept map that the device refuses, which is to be replaced
Result<ConnectedAxes> connectAxes(DeviceRegistry& registry, const std::string& name, bool ignoreKept) {
    Result<FoundDevice> found = registry.find(name);
    if (!found) return std::move(found).error();
    Result<AnyStylus> stylus = registry.make(found->id);
    if (!stylus) return std::move(stylus).error();
    ConnectedAxes connected{std::move(*found), std::move(*stylus), {}, {}};
    connected.mappable = mappableOf(connected.handle().device());
    connected.map = connected.mappable.usual;
    if (const Result<void> usable = checkAxisMap(connected.map, connected.mappable); !usable) return usable.error();
    const std::string kept = UserSettings().axisMap(connected.found.id);
    if (kept.empty() || ignoreKept) return connected;
    Result<AxisMap> map = axisMapFromJson(kept, connected.mappable);
    if (!map) return std::move(map).error();
    connected.map = *map;
    return connected;
}

/// The index of an axis or button, from its number and `=`. @param[out] rest behind it
std::optional<std::size_t> indexOf(const std::string& text, std::size_t count, std::string& rest) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) return std::nullopt;
    rest = text.substr(equals + 1);
    return indexOfNumber(text.substr(0, equals), count);
}

bool readPart(const std::string& part, AxisUse& use) {
    if (part == "reversed") {
        use.reversed = true;
        return true;
    }
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos) return false;
    const std::optional<double> value = parseNumber(part.substr(equals + 1));
    const std::string key = part.substr(0, equals);
    if (!value || (key != "gain" && key != "dead")) return false;
    (key == "gain" ? use.gain : use.deadZone) = *value;
    return true;
}

Error wrongAxis(const std::string& text, std::size_t count) {
    return Error{
        ErrorCode::argumentInvalid, "--axis", text,
        worded(BURIN_TEXT("Command", "N=MOTION[,reversed][,gain=G][,dead=SHARE] with N from 1 to %1 and one of "
                                     "the motions %2"),
               {std::to_string(count), axisMotionIds()})};
}

/// "2=z,reversed,gain=0.5,dead=0.1": what is left out keeps its value, except for the direction.
Result<void> applyAxis(const std::string& text, ConnectedAxes& connected) {
    const std::size_t count = connected.mappable.axes.size();
    std::string rest;
    const auto axis = indexOf(text, count, rest);
    if (!axis) return wrongAxis(text, count);
    AxisUse& use = connected.map.axes[*axis];
    const std::vector<std::string> parts = partsOf(rest, ',');
    const auto motion = axisMotionOf(parts.front());
    if (!motion) return wrongAxis(text, count);
    use.motion = *motion;
    use.reversed = false;
    for (std::size_t i = 1; i < parts.size(); ++i)
        if (!readPart(parts[i], use)) return wrongAxis(text, count);
    return {};
}

Result<void> applyButton(const std::string& text, ConnectedAxes& connected) {
    std::string rest;
    const auto button = indexOf(text, connected.mappable.buttons, rest);
    const auto action = buttonActionOf(rest);
    if (!button || !action)
        return Error{ErrorCode::argumentInvalid, "--button", text,
                     worded(BURIN_TEXT("Command", "N=ACTION with N from 1 to %1 and one of the actions %2"),
                            {std::to_string(connected.mappable.buttons), buttonActionIds()})};
    connected.map.buttons[*button] = *action;
    return {};
}

/// Stores a map for the window and other commands; the usual one leaves nothing behind.
Result<void> keepAxes(const ConnectedAxes& connected) {
    const bool usual = connected.map == connected.mappable.usual;
    const QString unwritten = UserSettings().setAxisMap(
        connected.found.id, usual ? std::string() : toJson(connected.map, connected.mappable));
    if (unwritten.isEmpty()) return {};
    return Error{ErrorCode::fileNotWritable, unwritten.toStdString(), {}, {}};
}

json answerOf(const ConnectedAxes& connected) {
    return {{"device", connected.found.id},
            {"usual", connected.map == connected.mappable.usual},
            {"map", json::parse(toJson(connected.map, connected.mappable))}};
}

std::string textOfAxes(const ConnectedAxes& connected) {
    return axisLines(connected.mappable, connected.map, QLocale::c()).join(QLatin1Char('\n')).toStdString();
}

} // namespace

int mapAxes(const AxesArguments& arguments, CommandContext& context) {
    DeviceRegistry registry;
    Result<ConnectedAxes> connected = connectAxes(registry, arguments.mapped, arguments.usual);
    if (!connected) return context.fail(connected.error());
    for (const std::string& axis : arguments.axes)
        if (const Result<void> applied = applyAxis(axis, *connected); !applied) return context.fail(applied.error());
    for (const std::string& button : arguments.buttons)
        if (const Result<void> applied = applyButton(button, *connected); !applied)
            return context.fail(applied.error());
    if (const Result<void> good = checkAxisMap(connected->map, connected->mappable); !good)
        return context.fail(good.error());
    if (arguments.usual || !arguments.axes.empty() || !arguments.buttons.empty())
        if (const Result<void> kept = keepAxes(*connected); !kept) return context.fail(kept.error());
    context.answer(answerOf(*connected), textOfAxes(*connected));
    return 0;
}

int calibrateAxes(const AxesArguments& arguments, CommandContext& context) {
    DeviceRegistry registry;
    Result<ConnectedAxes> connected = connectAxes(registry, arguments.calibrated, false);
    if (!connected) return context.fail(connected.error());
    AxisCalibration calibration(connected->mappable.axes, connected->map);
    const double end = AxisCalibration::restSeconds + arguments.motionSeconds;
    context.message(worded(BURIN_TEXT("Command", "Leave the device at rest.")));
    bool moves = false;
    const auto hear = [&](const AxisReading& reading, double seconds) {
        if (seconds < AxisCalibration::restSeconds) {
            calibration.rest(reading);
        } else {
            if (!std::exchange(moves, true))
                context.message(worded(BURIN_TEXT("Command", "Move every axis to both of its ends.")));
            calibration.move(reading);
        }
        context.progress().report(seconds / end);
        return seconds < end;
    };
    if (const Result<void> watched = watchAxes(connected->handle(), hear, context.progress()); !watched)
        return context.fail(watched.error());
    connected->map = calibration.proposed();
    if (const Result<void> good = checkAxisMap(connected->map, connected->mappable); !good)
        return context.fail(good.error());
    if (const Result<void> kept = keepAxes(*connected); !kept) return context.fail(kept.error());
    json answer = answerOf(*connected);
    std::vector<std::string> unchanged;
    for (std::size_t i = 0; i < connected->mappable.axes.size(); ++i) {
        const AxisCalibration::Measured seen = calibration.measured(i);
        answer["measured"].push_back({{"axis", connected->mappable.axes[i].name},
                                      {"rest", seen.rest},
                                      {"noise", seen.noise},
                                      {"low", seen.low},
                                      {"high", seen.high}});
        if (connected->mappable.axes[i].springs && seen.allZero())
            unchanged.push_back(worded({"Device", connected->mappable.axes[i].name.c_str()}));
    }
    if (!unchanged.empty())
        context.message(worded(BURIN_TEXT("Command", "Axes whose readings at rest were all 0 keep their rest and dead "
                                                     "zone (%1). If the device reports an axis only once it was moved, "
                                                     "move every axis once, then calibrate again."),
                               {listed(unchanged)}));
    context.answer(answer, textOfAxes(*connected));
    return 0;
}

void addAxesOptions(CommandParser command, AxesArguments& arguments, Argument test) {
    const Argument map =
        command
            .option("--map", arguments.mapped,
                    BURIN_TEXT("Help", "Show what the axes and buttons of this device do; changes are kept for the "
                                       "window and the command mill"))
            .excludes(test);
    command
        .option("--axis", arguments.axes,
                BURIN_TEXT("Help", "Assign an axis: N=MOTION[,reversed][,gain=G][,dead=SHARE], for example "
                                   "2=z,reversed,gain=0.5,dead=0.1"))
        .oneAtATime()
        .needs(map);
    command
        .option("--button", arguments.buttons,
                BURIN_TEXT("Help", "Assign a button: N=ACTION, for example 2=lift; mill, undo, clutch and others"))
        .oneAtATime()
        .needs(map);
    command
        .flag("--usual", arguments.usual, BURIN_TEXT("Help", "Begin with the usual assignment and without calibration"))
        .needs(map);
    const Argument calibrate =
        command
            .option("--calibrate", arguments.calibrated,
                    BURIN_TEXT("Help",
                               "Measure the axes of this device: two seconds at rest, then in motion; rest, ends "
                               "and dead zone are kept"))
            .excludes(test)
            .excludes(map);
    command
        .option("--motion-seconds", arguments.motionSeconds,
                BURIN_TEXT("Help", "Time for moving every axis to its ends, s"))
        .range(0.5, 600.0)
        .showDefault()
        .needs(calibrate);
}

} // namespace burin
