// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/part_faces.h"
#include "core/cad/reader/solid_mesh.h"

namespace burin {

/// Returns each face of each solid of a shape with its triangles, in the order and the frame of the shape.
/// @param chord mm, > 0 @param careful as in meshSolid
/// Errors, with an empty subject: meshIncomplete.
Result<std::vector<PartFacePatch>> facePatches(const TopoDS_Shape& shape, double chord, bool careful,
                                               const ReportFraction& report);

/// Returns, for each number in `SolidMesh::faceOf`, the index in `meshedFaces` of the solid's face. Parts of a divided
/// face are assigned to the face that is nearest to their largest triangle.
std::vector<std::uint32_t> ownersOf(const TopoDS_Shape& solid, const SolidMesh& mesh);

} // namespace burin
