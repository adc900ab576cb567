// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"

#include <cstdint>
#include <string>

namespace burin {

/// The arguments of `burin post --from`. Empty: as for the interrupted program.
struct RestartArguments {
    std::string project, output;
    std::string program; ///< file of the interrupted program; empty: the one that the project posted last
    std::uint32_t line = 0;
    std::string dialect, machine, units, overrideReason;
    double tolerance = 0.02; ///< mm, deepest gouge that is accepted
};

/// Writes the remainder of an interrupted program after it passed its check; the project is unchanged. @return exit
/// status
int runRestart(const RestartArguments& arguments, CommandContext& context);

} // namespace burin
