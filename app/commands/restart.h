// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"

#include <cstdint>
#include <string>

namespace burin {

/// What `burin post --from` is asked for. Empty: as the interrupted program was made.
struct RestartArguments {
    std::string project, output;
    std::string program; ///< file of the interrupted program; empty: the one that the project posted last
    std::uint32_t line = 0;
    std::string dialect, machine, units, overrideReason;
    double tolerance = 0.02; ///< mm, deepest gouge that passes
};

/// Writes the rest of an interrupted program, once it passes its check; the project stays as it is. @return exit status
int runRestart(const RestartArguments& arguments, CommandContext& context);

} // namespace burin
