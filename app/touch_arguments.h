// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command_line.h"
#include "core/document/project.h"

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

/// Touches the stock's sides one after the other; each becomes zero along its axis.
/// @param setup as placed @param part in the setup frame
/// Errors: argumentInvalid, those of toolFor, touchStock and placeZero.
Result<Setup> touchedOff(Setup setup, const TouchArguments& arguments, const Project& project, const Model& part);

} // namespace burin
