// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/program_job.h"

namespace burin {

/// All points of some paths, in their order, as one; for what goes by the points alone.
Path wholeOf(const std::vector<Path>& paths);

/// Feeds come down to what the check of a program of these paths found that spindle and tool bear, no lower than each
/// path lets them (Path::leastFeed) and where it does. A move that was split comes down as a whole.
/// @param kinematics of the machine with the program's zero. @return moves whose feed is lower than before
std::size_t lowerFeeds(std::vector<Path>& paths, const ParsedProgram& program, const std::vector<FeedLimit>& limits,
                       const Kinematics& kinematics);

} // namespace burin
