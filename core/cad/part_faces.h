// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/part_measure.h"

#include <vector>

namespace burin {

/// One face of a part, as it is measured and inspected. Model's frame.
struct PartFacePatch {
    MeasuredFace::Kind kind = MeasuredFace::Kind::other;
    double radius = 0.0; ///< mm: of a cylinder or sphere, of the tube of a torus; else 0 (a cone has many)
    double area = 0.0;   ///< mm²: exact on a B-rep, to 1e-6; of its triangles where there is none
    TriangleMesh mesh;   ///< chord `Model::meshChord`; those of neighbours do not share vertices
};

/// All faces of a part. Those of a B-rep in its own order, asked in the import program, which meshes it anew; of a mesh
/// file, which has no faces, the regions that FaceNeighbours takes for one, in the order of their first triangles: a
/// plane where they are flat to a micrometre, else `other`. Triangles without area belong to none.
/// Errors: as importModel, argumentInvalid (a model without a body).
Result<std::vector<PartFacePatch>> partFaces(const Model& model, const ImportOptions& options, Progress& progress);

} // namespace burin
