// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cad/import.h"
#include "core/tool/tool.h"

#include <filesystem>
#include <string>

namespace burin {

/// A cutter that is to be made of models of its flutes and its shank (paper, eq. 3). Both are in one frame: axis +Z, to
/// the holder, through the origin; the lowest point of the flutes becomes the tip.
struct ToolShapeRequest {
    std::filesystem::path flutes; ///< any of the formats of importModel
    std::filesystem::path shank;  ///< the same; empty: the shank of `like`
    Tool like; ///< number, flutes, what it bears, holder, and the shank where there is no model of it
    std::string id, name;
    double tolerance = 0.005; ///< mm, by which the profile may stand away from the axis
    ImportOptions import;
};

/// The tool, and what was done to the models.
struct ShapedTool {
    Tool tool;           ///< valid
    double lift = 0.0;   ///< mm, that the models were moved along Z, so that the tip is at 0
    double excess = 0.0; ///< mm, by which the profile is at most wider than what the flutes sweep in a turn; never less
    bool coarser = false; ///< than the tolerance that was asked for: a finer profile has too many lines
};

/// Reads the models and draws the profile of what they sweep while the spindle turns: every tool that turns cuts as
/// that profile does, whatever its teeth are like; where a tip is hollow, it is taken as filled.
/// Errors: those of importModel, argumentInvalid (a surface that is not closed; a shank that sticks out of
/// the flutes below their end, or ends there), those of `validate`.
Result<ShapedTool> shapedTool(const ToolShapeRequest& request, Progress& progress);

} // namespace burin
