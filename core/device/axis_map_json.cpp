// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/axis_map_json.h"

#include "core/base/json_object.h"
#include "core/base/numbers.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {
namespace {

using nlohmann::ordered_json;

constexpr std::array<std::string_view, motionCount + 1> motionIds{"none", "x", "y", "z", "a", "b", "c"};
constexpr std::array<std::string_view, 11> actionIds{"none",     "mill",        "lift",        "undo", "redo", "clutch",
                                                     "recentre", "level_above", "level_below", "edge", "fit"};
constexpr double leastGain = 0.05, mostGain = 10.0, mostDead = 0.5;
constexpr double farthest = 4.0; // nominal ranges: no device reads more

template <class Id, std::size_t count>
std::optional<Id> idIn(const std::array<std::string_view, count>& ids, std::string_view id) noexcept {
    const auto found = std::ranges::find(ids, id);
    if (found == ids.end()) return std::nullopt;
    return static_cast<Id>(found - ids.begin());
}

template <std::size_t count>
std::string joined(const std::array<std::string_view, count>& ids) {
    std::string all;
    for (const std::string_view id : ids) all += (all.empty() ? "" : ", ") + std::string(id);
    return all;
}

/// @param axis number from 1
Error refused(const char* subject, std::size_t axis, double value, const char* allowed) {
    return {ErrorCode::argumentInvalid, subject, std::to_string(axis) + ": " + formatShortest(value), allowed};
}

Result<void> checkUse(const AxisUse& use, std::size_t axis) {
    if (!(use.gain >= leastGain && use.gain <= mostGain)) return refused("gain of axis", axis, use.gain, "0.05 … 10");
    if (!(use.deadZone >= 0.0 && use.deadZone <= mostDead))
        return refused("dead zone of axis", axis, use.deadZone, "0 … 0.5");
    const bool ascends = -farthest <= use.low && use.low <= use.rest && use.rest <= use.high && use.high <= farthest;
    if (!ascends || !(use.low < use.high))
        return refused("rest of axis", axis, use.rest, "low end, rest and high end in ascending order, from -4 to 4");
    return {};
}

ordered_json jsonOf(const AxisUse& use, const DeviceAxis& axis) {
    return {{"axis", axis.name},         {"motion", idOf(use.motion)},
            {"reversed", use.reversed},  {"gain", use.gain},
            {"dead_zone", use.deadZone}, {"low", use.low},
            {"rest", use.rest},          {"high", use.high}};
}

AxisUse readUse(JsonObject& of) {
    AxisUse use;
    use.motion = static_cast<AxisMotion>(of.choice("motion", {motionIds.begin(), motionIds.end()}));
    use.reversed = of.boolean("reversed");
    use.gain = of.number("gain");
    use.deadZone = of.number("dead_zone");
    use.low = of.number("low");
    use.rest = of.number("rest");
    use.high = of.number("high");
    return use;
}

} // namespace

std::string_view idOf(AxisMotion motion) noexcept {
    return motionIds[static_cast<std::size_t>(motion)];
}

std::optional<AxisMotion> axisMotionOf(std::string_view id) noexcept {
    return idIn<AxisMotion>(motionIds, id);
}

std::string_view idOf(ButtonAction action) noexcept {
    return actionIds[static_cast<std::size_t>(action)];
}

std::optional<ButtonAction> buttonActionOf(std::string_view id) noexcept {
    return idIn<ButtonAction>(actionIds, id);
}

std::string axisMotionIds() {
    return joined(motionIds);
}

std::string buttonActionIds() {
    return joined(actionIds);
}

MappableDevice mappableOf(const StylusDevice& device) {
    const StylusDescription description = device.description();
    const auto buttons = static_cast<std::size_t>(std::max(0, description.buttons));
    return {description.name, device.axes(), device.axisMap(), std::min(buttons, AxisMap::mostButtons)};
}

Result<void> checkAxisMap(const AxisMap& map, const MappableDevice& device) {
    if (device.axes.empty() || device.axes.size() > AxisMap::mostAxes)
        return Error{ErrorCode::argumentInvalid, "device", device.name, "a device with axes to assign"};
    for (std::size_t i = 0; i < device.axes.size(); ++i)
        if (Result<void> good = checkUse(map.axes[i], i + 1); !good) return good;
    const auto end = map.buttons.begin() + static_cast<std::ptrdiff_t>(device.buttons);
    if (device.buttons > 0 && std::find(map.buttons.begin(), end, ButtonAction::mill) == end)
        return Error{ErrorCode::argumentInvalid, "buttons", {}, "at least one button that mills"};
    return {};
}

std::string toJson(const AxisMap& map, const MappableDevice& device) {
    ordered_json file{{"axes", ordered_json::array()}, {"buttons", ordered_json::array()}};
    for (std::size_t i = 0; i < device.axes.size(); ++i) file["axes"].push_back(jsonOf(map.axes[i], device.axes[i]));
    for (std::size_t i = 0; i < device.buttons; ++i) file["buttons"].push_back(idOf(map.buttons[i]));
    return file.dump();
}

Result<AxisMap> axisMapFromJson(std::string_view text, const MappableDevice& device) {
    Result<JsonObject> file = JsonObject::parse(text, device.name);
    if (!file) return std::move(file).error();
    AxisMap map = device.usual;
    file->objects("axes", [&](JsonObject& of) {
        const auto axis = std::ranges::find(device.axes, of.text("axis"), &DeviceAxis::name);
        const AxisUse use = readUse(of);
        if (axis != device.axes.end()) map.axes[static_cast<std::size_t>(axis - device.axes.begin())] = use;
    });
    const std::vector<std::string> buttons = file->texts("buttons");
    for (std::size_t i = 0; i < std::min(buttons.size(), map.buttons.size()); ++i) {
        const std::optional<ButtonAction> action = buttonActionOf(buttons[i]);
        if (!action) file->fail("buttons", buttonActionIds());
        map.buttons[i] = action.value_or(ButtonAction::none);
    }
    if (Result<void> read = file->finish(); !read) return std::move(read).error();
    if (Result<void> good = checkAxisMap(map, device); !good) return std::move(good).error();
    return map;
}

Result<void> assignKept(StylusDevice& device, std::string_view kept) {
    const MappableDevice mappable = mappableOf(device);
    if (mappable.axes.empty()) return {};
    const Result<AxisMap> map = kept.empty() ? Result<AxisMap>(mappable.usual) : axisMapFromJson(kept, mappable);
    if (!map) return map.error();
    device.assign(*map);
    return {};
}

} // namespace burin
