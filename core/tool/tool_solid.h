// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/json_object.h"
#include "core/base/result.h"
#include "core/geometry/triangle_mesh.h"

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

namespace burin {

struct Cutter;

/// The true shape of a tool that doesn't turn: a scraper, a shaping or planing blade. Tool frame: tip at the origin,
/// axis +Z towards the holder. The tool stands upright; its direction about the axis is fixed in the setup frame.
struct ToolSolid {
    static constexpr std::size_t mostTriangles = 100'000; ///< of flutes and shank together

    TriangleMesh flutes; ///< mm, closed: what cuts
    TriangleMesh shank;  ///< mm, closed: what must not touch; empty: the cylinder of the cutter's shank
    double angle = 0.0;  ///< rad, from X of the setup to X of the models, counterclockwise seen from the holder
};

/// Returns the mesh of a tool, turned by an angle (rad) about the axis: in the setup frame, tip at the origin.
TriangleMesh turnedAboutAxis(const TriangleMesh& mesh, double angle);

/// Checks the solid of a cutter, which must not be null, against the cutter's profile, which encloses it.
/// Errors: argumentInvalid (the key, what is allowed): a surface with holes, too many triangles, a model that leaves
/// the profile or the shank, a stick-out other than the height of the shank.
Result<void> validateSolid(const Cutter& cutter);

/// Reads the solid of a cutter whose file states `"turns": false`. Faults stay with `from`.
ToolSolid readSolid(JsonObject& from);
/// Writes the keys that `readSolid` reads.
void writeSolid(const ToolSolid& solid, nlohmann::ordered_json& cutter);

} // namespace burin
