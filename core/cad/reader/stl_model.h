// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/model.h"

#include <string_view>

namespace burin {

/// Returns the model of an STL file: one body for each `solid` of a text file, one for a binary file; unconnected
/// pieces are separated, triangles with inconsistent orientation turned. @param unit mm per unit of the file. Errors,
/// with an empty subject: fileDamaged, modelHasNoSolid (triangles with so many open edges that they enclose nothing).
Result<Model> readStlModel(std::string_view content, bool binary, double unit);

} // namespace burin
