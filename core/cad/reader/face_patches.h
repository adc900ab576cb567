// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/part_faces.h"
#include "core/cad/reader/solid_mesh.h"

namespace burin {

/// Each face of each solid of a shape with its triangles, in the order of the shape and in its frame.
/// @param chord mm, > 0 @param careful as meshSolid
/// Errors, with an empty subject: meshIncomplete.
Result<std::vector<PartFacePatch>> facePatches(const TopoDS_Shape& shape, double chord, bool careful,
                                               const ReportFraction& report);

/// The face of a solid, by its number among `meshedFaces`, that each number of `SolidMesh::faceOf` stands for. Those of
/// divided faces lie on the face that their largest triangle is nearest to.
std::vector<std::uint32_t> ownersOf(const TopoDS_Shape& solid, const SolidMesh& mesh);

} // namespace burin
