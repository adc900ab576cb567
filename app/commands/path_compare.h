// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"
#include "core/path/path_comparison.h"

#include <cstdint>
#include <optional>
#include <string>

namespace burin {

/// The arguments of a comparison, as given on the command line.
struct CompareArguments {
    std::int64_t second = 0;              ///< id of the second path; 0: another version of the first one
    std::optional<std::string> without{}; ///< position of the edit that the other version omits
    bool recorded = false;                ///< the other version has no edits
    double tolerance = usualComparedTolerance;
};

/// Declares the arguments of a comparison, which must outlive the parsing, and the machine.
void addCompare(CommandParser part, CompareArguments& compare, std::string& machine);

/// Evaluates a path and the version that it is compared with, and answers with the values of both.
/// @param project file @param machine id; empty: that of the project @return exit status
int comparePathsOf(const std::string& project, std::int64_t first, const CompareArguments& arguments,
                   const std::string& machine, CommandContext& context);

} // namespace burin
