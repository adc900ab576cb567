// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"
#include "core/geometry/box.h"
#include "core/geometry/mesh_distance.h"
#include "core/passes/workpiece_heights.h"
#include "core/setup/obstacle.h"
#include "core/tool/tool.h"

#include <cstddef>
#include <span>
#include <vector>

namespace burin {

/// What a pass is planned on: part, stock and tool, setup frame, mm. What it refers to outlives it.
struct PassGround {
    const MeshDistance& part;    ///< what nothing may cut; may be empty
    const ClearanceField& field; ///< of the tool from the part, fine at least up to the allowance of the pass
    const Tool& tool;
    Box stock;
    std::span<const ObstacleSolid> obstacles; ///< that the tool keeps clear of
    StandingStock standing;                   ///< what has been left of the stock; none: the whole box stands
    double levelDepth = 0.0;                  ///< mm: the deepest level that tool, spindle and material bear
    double rowDepth = 0.0; ///< mm: the deepest cut of a row beside the one before it, as the tool states it
    /// Rows, rasters and places are so many times as far apart as a pass has them: of a preview. 1: the pass itself.
    double coarseness = 1.0;
};

/// Tips of one stretch of a pass, mm.
using TipLine = std::vector<glm::dvec3>;

/// mm
inline double lengthOf(const TipLine& line) noexcept {
    double length = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) length += glm::distance(line[i - 1], line[i]);
    return length;
}

/// What a planner made.
struct PlannedPass {
    std::vector<TipLine> strokes;
    /// mm of ways that were left out: so much stock stands there that shank or holder would touch it, or that the cut
    /// would be deeper than the tool bears. Roughing has to come first, or a longer tool.
    double leftOut = 0.0;
    double inTheWay = 0.0;          ///< mm of ways that were left out because of fixtures and keep-out volumes
    std::size_t unreachedHoles = 0; ///< of `drill`: the part, or the length of the drill, keeps it from their bottom
};

} // namespace burin
