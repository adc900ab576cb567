// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/reader/mesh_model.h"

#include <string_view>
#include <vector>

namespace burin {

/// What assimp reads of a file in its memory: a solid for each node that has triangles, as often as it stands in the
/// scene, with the placements of its parents. Coordinates have the 24 bits of a float. Files that it refers to are not
/// opened. Errors, with an empty subject: fileDamaged (detail: in assimp's words).
/// @param format suffix that assimp knows the format by
Result<std::vector<MeshSolid>> readScene(std::string_view content, const char* format);

} // namespace burin
