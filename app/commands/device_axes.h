// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"

#include <string>
#include <vector>

namespace burin {

/// The arguments of --map and --calibrate.
struct AxesArguments {
    std::string mapped, calibrated; ///< id or name of a device; at most one is not empty
    std::vector<std::string> axes, buttons;
    bool usual = false;
    double motionSeconds = 10.0;
};

/// Declares the options of `devices` that show, change and calibrate the assignment of a device's axes.
/// @param test option that excludes them
void addAxesOptions(CommandParser command, AxesArguments& arguments, Argument test);

/// Shows the assignment of a device's axes and buttons and stores the changes, for the window and `mill`.
int mapAxes(const AxesArguments& arguments, CommandContext& context);
/// Measures the axes of a device at rest and in motion and stores their calibration.
int calibrateAxes(const AxesArguments& arguments, CommandContext& context);

} // namespace burin
