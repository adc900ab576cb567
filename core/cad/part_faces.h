// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/part_measure.h"

#include <vector>

namespace burin {

/// One face of a part, for measuring and inspection. Frame of the model.
struct PartFacePatch {
    MeasuredFace::Kind kind = MeasuredFace::Kind::other;
    double radius = 0.0; ///< mm: of a cylinder or sphere, or of the tube of a torus; otherwise 0 (a cone has many)
    double area = 0.0;   ///< mm²: exact for a B-rep, to 1e-6; otherwise that of its triangles
    TriangleMesh mesh;   ///< chord `Model::meshChord`; shares no vertices with neighbouring faces
};

/// Returns all faces of a part. Those of a B-rep are in its own order and come from the import program, which meshes it
/// again. A mesh file has no faces: its regions by FaceNeighbours are returned, in the order of their first triangles,
/// as `plane` if flat to a micrometre, otherwise `other`. Triangles without area belong to no face.
/// Errors: as importModel, argumentInvalid (a model without a body).
Result<std::vector<PartFacePatch>> partFaces(const Model& model, const ImportOptions& options, Progress& progress);

} // namespace burin
