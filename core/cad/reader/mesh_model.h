// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/model.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// One solid of a mesh file.
struct MeshSolid {
    std::string name;                 ///< may be empty
    TriangleMesh mesh;                ///< in the file's own unit; vertices are merged where they are bit-identical
    BodyColour colour = std::nullopt; ///< sRGB
};

void addNote(Model& model, ImportNote::Kind kind, std::string text);

/// Makes the bodies of a model whose format and unit are already set: measures them in mm, separates unconnected pieces
/// and turns triangles with inconsistent orientation, with a note for each. Errors, with an empty subject:
/// modelHasNoSolid (no triangles, or so many open edges that they enclose nothing).
Result<Model> withBodies(Model model, std::vector<MeshSolid> solids);

/// Sets the unit of a file that states none, and adds a note about it. @param millimetres per unit
void takeUnit(Model& model, double millimetres);

} // namespace burin
