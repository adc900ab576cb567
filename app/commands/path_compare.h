// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/command.h"
#include "core/path/path_comparison.h"

#include <cstdint>
#include <optional>
#include <string>

namespace burin {

/// What the command line says of a comparison, as it was written.
struct CompareArguments {
    std::int64_t second = 0;              ///< path; 0: the first one in another version
    std::optional<std::string> without{}; ///< position of the edit that the other version lacks
    bool recorded = false;                ///< the other version has no edits
    double tolerance = usualComparedTolerance;
};

/// Evaluates a path and what it is compared with, and answers with both.
/// @param project file @param machine by id; empty: the project's @return exit status
int comparePathsOf(const std::string& project, std::int64_t first, const CompareArguments& arguments,
                   const std::string& machine, CommandContext& context);

} // namespace burin
