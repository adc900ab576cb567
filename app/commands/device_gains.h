// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"
#include "core/haptics/force/suggested_gains.h"

#include <optional>
#include <string>

namespace burin {

/// The arguments of `devices --test` about gains, and of --previous-gains.
struct GainArguments {
    std::optional<double> ceiling; ///< N/mm; 0: none
    std::optional<double> friction;
    bool keeps = false;
    std::string restored; ///< id or name of a device; empty: none
};

/// Declares the options of `devices` for gains. @param test option that some of them need
void addGainOptions(CommandParser command, GainArguments& arguments, Argument test);

/// Adds the gains that a test suggests to its answer, and keeps them if the arguments say so, for the window and
/// `mill`. Errors: fileNotWritable; argumentInvalid (there is nothing to keep).
Result<void> answerGains(const std::string& device, const StylusDescription& stylus, const TrialFigures& figures,
                         const GainArguments& arguments, nlohmann::json& answer, std::string& text);

/// Uses the gains of a device again that were in use before the last change.
int restoreGains(const GainArguments& arguments, CommandContext& context);

} // namespace burin
