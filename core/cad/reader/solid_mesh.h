// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/reader/reader_progress.h"
#include "core/geometry/triangle_mesh.h"

#include <TopoDS_Compound.hxx>
#include <TopoDS_Solid.hxx>

#include <cstddef>

namespace burin {

/// The mesh of one solid and how it came about.
struct SolidMesh {
    TriangleMesh mesh;
    std::size_t openEdges = 0;
    std::size_t facesWithoutTriangles = 0;
    std::size_t facesFilled = 0; ///< plane faces that OpenCASCADE left empty and that were filled from their boundary
    std::size_t attempts = 1;    ///< how often the whole solid was meshed
    TopoDS_Compound torn;        ///< the faces to blame for what is missing or open; null when there is none
};

/// Meshes a solid with a chord of at most `chord` mm. OpenCASCADE's mesher may leave faces of a valid solid empty; its
/// status is not trusted but the result looked at, and what is missing is filled or tried again with a finer chord. An
/// open edge where the faces themselves don't meet is left: no chord closes it. The solid carries a triangulation
/// afterwards. @param careful without the faster of the two algorithms
SolidMesh meshSolid(const TopoDS_Solid& solid, double chord, const ReportFraction& report, bool careful = false);

} // namespace burin
