// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/geometry/placement.h"
#include "core/geometry/triangle_mesh.h"
#include "core/setup/fixture_kind.h"

#include <vector>

namespace burin {

/// One step of a round body, a cylinder about its axis.
struct RoundStep {
    double radius = 0.0, low = 0.0, high = 0.0; ///< mm
    bool inStock = false;                       ///< whether it may be in the stock: a screw in its hole
};

/// Steps with a common vertical axis, from the bottom upwards, each on the one before.
struct RoundBody {
    glm::dvec2 centre{0.0}; ///< mm
    std::vector<RoundStep> steps;
};

/// The solids of a fixture, in its own frame: boxes that are united, less what is cut away from them, and round bodies.
/// No solid touches another one: where a nut stands on a bar, a gap of `solidGap` lies between them, so that the
/// surface stays closed and has an inside everywhere.
struct FixtureSolids {
    std::vector<Box> boxes, cutAway;
    std::vector<RoundBody> rounds;
};
inline constexpr double solidGap = 0.01; ///< mm

/// @param design has passed checkFixture
FixtureSolids solidsOf(const FixtureDesign& design);

/// Returns where a vise or a clamp meets the stock, in the fixture's own frame, mm; unbounded in the direction of
/// clamping: the space between the jaws (along x), below the nose of a step clamp (along z), before the nose of a toe
/// clamp (along x). @param design a vise, step clamp or toe clamp
Box gripOf(const FixtureDesign& design);

/// From the frame of the fixture to the setup frame; exact for quarter turns.
Placement placementOf(const FixtureDesign& design) noexcept;

/// Returns the surface of the fixture in the setup frame, closed and oriented outwards. Boxes are exact, quarter turns
/// too; round bodies are enclosed, and wider by `cylinderChord` (core/setup/obstacle.h) at most.
/// @param design has passed checkFixture
TriangleMesh meshOf(const FixtureDesign& design);

} // namespace burin
