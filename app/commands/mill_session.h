// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"
#include "app/commands/mill_options.h"
#include "core/base/staged_file.h"
#include "core/job/milling.h"

#include <optional>
#include <string_view>
#include <vector>

namespace burin {

inline constexpr std::string_view tracePrefix = "trace:";
inline constexpr std::string_view devicePrefix = "device:";

/// The work to be done with one stylus on a project.
struct MillWork {
    const MillArguments& arguments;
    Project& project;
    MillingContext& milling;
    const ToolBounds& bounds;
    CommandContext& context;
    Pace pace;
    nlohmann::json& answer;                ///< receives the values reported for the whole session
    std::optional<StagedFile>& trace;      ///< receives the requested trace
    OpenedSessionTrace* played;            ///< the trace that serves as the stylus; null: none
    std::optional<GuideSettings> guides{}; ///< for hand guidance
    double assist = 0.0;                   ///< as in FeltCutting
    GainLimits gains{};
};

/// Mills with the stylus that the arguments name: the operator, a trace or a device. Errors: those of recordTake and
/// millWithOperator, argumentInvalid, nameUnknown (the stylus), those of the device's driver.
Result<std::vector<TakeOutcome>> millAsAsked(const MillWork& work);

} // namespace burin
