// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/nc/dialect.h"
#include "core/path/path.h"

namespace burin {

struct PostRequest {
    std::string programName;
    std::vector<std::string> header;  ///< comment lines
    glm::dvec3 workOffset{0.0};       ///< program zero in the setup frame, mm
    int toolNumber = 1;
    std::string toolName;
    double safeHeight = 0.0;          ///< mm above program zero
    double blendTolerance = 0.005;    ///< mm
};

/// A path as a program: frames changed, moves in order. Errors: pathEmpty, programLimit (feed, speed, travel beyond the
/// machine's, a feed that is missing).
Result<NcProgram> toProgram(const std::vector<Path>& paths, const PostRequest& request, const MachineProfile& machine);

/// The text of a program in a dialect. Errors: the dialect's; programLimit (a line longer than the control reads).
Result<std::string> writeProgram(const NcProgram& program, const MachineProfile& machine, const PostProcessor& post,
                                 Progress& progress);

} // namespace burin
