// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/reader/mesh_model.h"

#include <string_view>
#include <vector>

namespace burin {

/// Reads the content of a file with assimp: returns a solid for each node that has triangles, once for each occurrence
/// in the scene, with the placements of its parents. Coordinates have the 24 bits of a float. Files that it refers to
/// are not opened. Errors, with an empty subject: fileDamaged (detail: assimp's message).
/// @param format suffix by which assimp knows the format
Result<std::vector<MeshSolid>> readScene(std::string_view content, const char* format);

} // namespace burin
