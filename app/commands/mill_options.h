// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command_line.h"
#include "core/job/milling.h"

#include <optional>
#include <string>

namespace burin {

/// The arguments of `burin mill`, as given by the user.
struct MillArguments {
    std::string project, stylus = "operator", mode, tool, machine, trace, axis, from;
    bool realtime = false, fast = false, overrides = false;
    double seconds = 0.0, rate = 1000.0;
    int deadMan = 0;       ///< number of the button, from 1; 0: none
    bool noGuides = false; ///< the guides of the project are disabled
    std::string grip = "firm", intent = "passes";
    std::optional<double> allowance, felt, assist, stockDistance;
    OperatorRequest hand;
};

/// Declares the arguments of `burin mill`.
void addMillOptions(CommandParser command, MillArguments& arguments);

/// The values of --grip and --intent.
HandImpedance gripOf(const MillArguments& arguments);
OperatorIntent intentOf(const MillArguments& arguments);

} // namespace burin
