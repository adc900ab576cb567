// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/reader/reader_progress.h"
#include "core/geometry/triangle_mesh.h"

#include <TopoDS_Compound.hxx>
#include <TopoDS_Solid.hxx>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin {

/// The mesh of one solid and how it was made.
struct SolidMesh {
    TriangleMesh mesh;
    std::vector<std::uint32_t> faceOf; ///< face number of each triangle, in `meshedFaces` of the meshed shape
    bool divided = false;              ///< the meshed shape is not the solid: its closed faces are divided in halves
    std::size_t openEdges = 0;
    std::size_t facesWithoutTriangles = 0;
    std::size_t facesFilled = 0; ///< plane faces left empty by OpenCASCADE and filled from their boundary
    std::size_t attempts = 1;    ///< number of times that the whole solid was meshed
    TopoDS_Compound torn;        ///< the faces that cause missing triangles or open edges; null if there are none
};

/// Meshes a solid with a chord of at most `chord` mm. OpenCASCADE's mesher may leave faces of a valid solid empty;
/// instead of trusting its status, the result is checked, and missing triangles are filled or tried again with a finer
/// chord. An open edge where the faces themselves don't meet is left: no chord closes it. The solid carries a
/// triangulation afterwards. @param careful do not use the faster of the two algorithms
SolidMesh meshSolid(const TopoDS_Solid& solid, double chord, const ReportFraction& report, bool careful = false);

} // namespace burin
