// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/nc/dialect.h"
#include "core/path/path.h"

#include <map>

namespace burin {

/// A tool as a program names it.
struct PostTool {
    int number = 1;
    std::string name;
    SpindleDirection direction = SpindleDirection::clockwise;
};

struct PostRequest {
    std::string programName;
    std::vector<std::string> header; ///< comment lines
    glm::dvec3 workOffset{0.0};      ///< program zero in the setup frame, mm
    int workOffsetNumber = 54;       ///< as NcProgram::workOffset
    NcUnits units = NcUnits::millimetre;
    int toolNumber = 1;
    std::string toolName;
    std::map<std::string, PostTool> tools; ///< by Path::toolId; empty: all paths use the one tool above
    double safeHeight = 0.0;               ///< mm above program zero
    double blendTolerance = 0.005;         ///< mm
};

/// Converts paths to a program: poses become values of the machine's axes (`kinematicsOf`), moves and arcs stay in
/// order, and each change of tool or spindle speed begins a section. Errors: pathEmpty, programLimit (feed, speed or
/// travel beyond the machine's, a missing feed, a pose in which the machine cannot hold the tool), argumentInvalid (a
/// path that does not begin with a rapid, a tool that the request does not name, a rapid arc).
Result<NcProgram> toProgram(const std::vector<Path>& paths, const PostRequest& request, const MachineProfile& machine);

/// The text of a program in a dialect. Errors: those of the dialect; programLimit (a line longer than the control
/// reads).
Result<std::string> writeProgram(const NcProgram& program, const MachineProfile& machine, const PostProcessor& post,
                                 Progress& progress);

} // namespace burin
