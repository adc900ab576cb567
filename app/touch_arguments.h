// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command_line.h"
#include "core/document/project.h"
#include "core/job/touched_stock.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace burin {

/// The arguments for touching off, as given by the user.
struct TouchArguments {
    std::vector<std::string> touches;
    std::string tool = "ball-6";

    bool empty() const { return touches.empty(); }
};

/// Declares --touch and --touch-tool.
void addTouches(CommandParser command, TouchArguments& arguments);

/// A side of the stock that became zero along an axis.
struct TouchedAxis {
    int axis = 0; ///< 0, 1, 2 for x, y, z
    TouchedSide side;
};
struct TouchedOff {
    Setup setup; ///< with its new zero
    std::vector<TouchedAxis> sides;
};

/// Touches the stock's sides one after the other; each becomes zero along its axis.
/// @param setup as placed @param part in the setup frame
/// Errors: argumentInvalid, those of TouchableStock::of, toolFor, touchStock and placeZero.
Result<TouchedOff> touchedOff(Setup setup, const TouchArguments& arguments, const Project& project, const Model& part,
                              Progress& progress);

/// [{"axis", "coordinate_mm", "error_mm"}]
nlohmann::json jsonOf(const std::vector<TouchedAxis>& sides);
/// A line for each, after a line break.
std::string textOf(const std::vector<TouchedAxis>& sides);

} // namespace burin
