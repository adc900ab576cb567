// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/import.h"

namespace burin {

/// An edge between two faces of a part, as points and tangents of its curve. Model's frame.
struct PartEdge {
    std::vector<glm::dvec3> points;   ///< mm, two or more; a closed edge repeats its first at the end
    std::vector<glm::dvec3> tangents; ///< unit, one a point, the way the points go
    double length = 0.0;              ///< mm, of the points' polyline
};

/// The edges of a model's B-rep, in its own order; points so near that the curve is within `chord` of the
/// polyline. Left out: seams of faces that close upon themselves, and edges that are a point. Runs in the import
/// program. Errors: as importModel, argumentInvalid (no B-rep, a chord not > 0).
Result<std::vector<PartEdge>> partEdges(const Model& model, double chord, const ImportOptions& options,
                                        Progress& progress);

} // namespace burin
