// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/json_object.h"
#include "core/base/result.h"
#include "core/geometry/plan_region.h"
#include "core/geometry/triangle_mesh.h"

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <span>

namespace burin {

struct Cutter;
struct ProfileElement;

/// The true shape of a tool that its profile does not describe. Either it doesn't turn: a scraper, a shaping or planing
/// blade. Or it turns and is hollow: a core drill, an annular cutter, a hollow mill. Tool frame: tip at the origin,
/// axis +Z towards the holder. The tool stands upright; its direction about the axis, if it doesn't turn, is fixed in
/// the setup frame.
struct ToolSolid {
    static constexpr std::size_t mostTriangles = 100'000; ///< of flutes and shank together
    static constexpr std::size_t mostCorners = 1'000;     ///< of the section

    TriangleMesh flutes;  ///< mm, closed: what cuts; of a tool that turns, what its section sweeps (hollow_tip.h)
    TriangleMesh shank;   ///< mm, closed: what must not touch; empty: the cylinder of the cutter's shank
    double angle = 0.0;   ///< rad, from X of the setup to X of the models, counterclockwise seen from the holder
    PlanRegion section{}; ///< of the flutes of a tool that turns: (distance from the axis, height above the tip), mm
    // Of a tool that turns, mm: how high above the tip its hollow reaches, and its largest diameter.
    double hollowDepth = 0.0, hollowWidth = 0.0;

    bool turns() const noexcept { return !section.empty(); }
};

/// Returns the mesh of a tool, turned by an angle (rad) about the axis: in the setup frame, tip at the origin.
TriangleMesh turnedAboutAxis(const TriangleMesh& mesh, double angle);

/// Checks the solid of a cutter, which must not be null, against the cutter's profile, which encloses it.
/// Errors: argumentInvalid (the key, what is allowed): a surface with holes, too many triangles, a model that leaves
/// the profile or the shank, a stick-out other than the height of the shank; a section that leaves the profile.
Result<void> validateSolid(const Cutter& cutter);

/// Reads the solid of a cutter whose file states `"turns": false`. Faults stay with `from`.
ToolSolid readSolid(JsonObject& from);
/// Reads the solid of a cutter that turns and whose file has a section. Faults stay with `from`.
ToolSolid readTurningSolid(JsonObject& from, std::span<const ProfileElement> profile);
/// Writes the keys that these read.
void writeSolid(const ToolSolid& solid, nlohmann::ordered_json& cutter);

} // namespace burin
