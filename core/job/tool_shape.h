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

/// A request for a cutter made from models of its flutes and its shank (paper, eq. 3). Both are in one frame: axis +Z,
/// towards the holder, through the origin; the lowest point of the flutes becomes the tip.
struct ToolShapeRequest {
    std::filesystem::path flutes; ///< any of the formats of importModel
    std::filesystem::path shank;  ///< in the same formats; empty: the shank of `like`
    Tool like;                    ///< provides number, flutes, limits, holder, and the shank if there is no model of it
    std::string id, name;
    double tolerance = 0.005; ///< mm, by which the profile may be farther from the axis
    bool turns = true;        ///< false: the models themselves are the tool, which doesn't turn (tool_solid.h)
    double angle = 0.0;       ///< rad, of a tool that doesn't turn: ToolSolid::angle
    ImportOptions import;
};

/// The tool, and the changes made to the models.
struct ShapedTool {
    Tool tool;           ///< valid
    double lift = 0.0;   ///< mm, by which the models were moved along Z so that the tip is at 0
    double excess = 0.0; ///< mm, largest excess of the profile over the volume swept by the flutes; never narrower
    double hollowExcess = 0.0; ///< mm, by which a hollow may be narrower than that of the flutes; never wider
    bool coarser = false;      ///< than the requested tolerance: a finer profile has too many lines
};

/// Reads the models and computes the profile of the volume that they sweep while the spindle turns: a rotating tool
/// cuts like this profile, regardless of the shape of its teeth. Where that volume is hollow, the tool keeps its
/// section as well (ToolSolid::section). A tool that doesn't turn keeps the models as its shape. In both cases the
/// profile is the bound that keeps the tool out of the part. Errors: cancelled, those of importModel, argumentInvalid
/// (a surface that is not closed; a shank that protrudes from the flutes below their end, or ends there), those of
/// `validate`.
Result<ShapedTool> shapedTool(const ToolShapeRequest& request, Progress& progress);

} // namespace burin
