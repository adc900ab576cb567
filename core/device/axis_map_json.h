// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/device/stylus.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// The id of a motion in files and on the command line: "none", "x", … "c".
std::string_view idOf(AxisMotion motion) noexcept;
std::optional<AxisMotion> axisMotionOf(std::string_view id) noexcept;
/// The id of an action in files and on the command line: "none", "mill", "lift", "level_above", …
std::string_view idOf(ButtonAction action) noexcept;
std::optional<ButtonAction> buttonActionOf(std::string_view id) noexcept;
/// All ids, for messages, separated by commas.
std::string axisMotionIds();
std::string buttonActionIds();

/// What a device lets the user assign.
struct MappableDevice {
    std::string name;
    std::vector<DeviceAxis> axes;
    AxisMap usual; ///< unless the user assigns something else
    std::size_t buttons = 0;
};
MappableDevice mappableOf(const StylusDevice& device);

/// Checks whether a map can be used with a device. Errors: argumentInvalid (place: number of the axis, from 1, and the
/// value).
Result<void> checkAxisMap(const AxisMap& map, const MappableDevice& device);

/// The map of a device as one JSON object. Axes are listed by name.
std::string toJson(const AxisMap& map, const MappableDevice& device);
/// Axes of the device that the text does not name keep their usual assignment; others are ignored. Errors:
/// resourceInvalid, those of checkAxisMap.
Result<AxisMap> axisMapFromJson(std::string_view text, const MappableDevice& device);

/// Assigns the map that the user keeps for a device, or the usual one if there is none. Nothing for a device without
/// axes. @param kept as from toJson; empty: none
/// Errors: those of axisMapFromJson; nothing is assigned then.
Result<void> assignKept(StylusDevice& device, std::string_view kept);

} // namespace burin
