// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/program_job.h"

namespace burin {

/// Returns one path with the points of all given paths, in order; for functions that only use the points.
Path wholeOf(const std::vector<Path>& paths);

/// Lowers feeds to the limits of spindle and tool that the check of a program of these paths found, if the path allows
/// it (Path::leastFeed), and not below that feed. The feed of a split move is lowered for the entire move.
/// @param kinematics of the machine with the program's zero. @return number of moves whose feed was lowered
std::size_t lowerFeeds(std::vector<Path>& paths, const ParsedProgram& program, const std::vector<FeedLimit>& limits,
                       const Kinematics& kinematics);

} // namespace burin
