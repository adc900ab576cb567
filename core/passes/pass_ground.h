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
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// The geometry that a pass is planned on: part, stock and tool, setup frame, mm. Everything it refers to must outlive
/// it.
struct PassGround {
    const MeshDistance& part; ///< what nothing may cut; may be empty
    /// Clearance of the tool from the part, fine at least up to the allowance of the pass; null for passes that need
    /// none (needsField in plan_pass.h).
    const ClearanceField* field;
    const Tool& tool;
    Box stock;
    std::span<const ObstacleSolid> obstacles; ///< that the tool keeps clear of
    StandingStock standing;                   ///< what is left of the stock; empty: the whole box stands
    double levelDepth = 0.0;                  ///< mm: depth of a level where the request states none
    double rowDepth = 0.0; ///< mm: the largest depth of cut of a row next to the one before it, as the tool states it
    /// Factor for the distances of rows, rasters and points; > 1 for a preview, 1 for the pass itself.
    double coarseness = 1.0;
    double loopStep = 0.0; ///< mm: between loops of a level where the request states none; 0: a share of the diameter
    /// Strokes of the hand that come before the pass in its path; a request decides whether they matter.
    std::vector<std::vector<glm::dvec3>> handStrokes{};
};

/// The tip positions of one continuous part of a pass, mm.
using TipLine = std::vector<glm::dvec3>;

/// mm
inline double lengthOf(const TipLine& line) noexcept {
    double length = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) length += glm::distance(line[i - 1], line[i]);
    return length;
}

/// The result of a planner.
struct PlannedPass {
    std::vector<TipLine> strokes;
    /// Length of path that was left out, mm: so much stock stands there that the shank or holder would touch it, or
    /// that the cut would be deeper than the tool can bear. Rough first, or use a longer tool.
    double leftOut = 0.0;
    double inTheWay = 0.0;   ///< length of path left out because of fixtures and keep-out volumes, mm
    double leftToHand = 0.0; ///< length of path left out because strokes of the hand have finished the part there, mm
    /// of `drill`: holes whose bottom cannot be reached because of the part or the length of the drill; of `thread`:
    /// holes left without a thread, as they, or their drillings, are not as deep as it; studs without room for the tool
    /// around them
    std::size_t unreachedHoles = 0;
    /// of `thread`: height down to which those have to be drilled with their full diameter, or milled to the major
    /// diameter, mm, setup frame; 0 if there are none
    double neededDrilling = 0.0;
    /// The first of the studs that are not milled to the thread's major diameter yet.
    struct UnmilledStud {
        double diameter = 0.0, allowed = 0.0; ///< mm: what stands there, the major diameter
    };
    std::optional<UnmilledStud> unmilledStud{};
    /// Feed of the tool's centre to each point of each stroke, as a share of the cutting feed; 0: the tool moves along
    /// its axis through air. Empty: all cutting feed.
    std::vector<std::vector<double>> feedShares{};
};

} // namespace burin
