// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/import.h"

namespace burin {

/// An edge between two faces of a part, as points and tangents of its curve. Frame of the model.
struct PartEdge {
    std::vector<glm::dvec3> points;   ///< mm, two or more; a closed edge repeats its first point at the end
    std::vector<glm::dvec3> tangents; ///< unit, one for each point, in the direction of the points
    double length = 0.0;              ///< mm, of the points' polyline
};

/// Returns the edges of a model's B-rep, in its own order, with points so dense that the curve is within `chord` (mm)
/// of the polyline. Seams of closed faces and degenerate edges are left out. Runs in the import program. Errors: as
/// importModel, argumentInvalid (no B-rep, or `chord` is not > 0).
Result<std::vector<PartEdge>> partEdges(const Model& model, double chord, const ImportOptions& options,
                                        Progress& progress);

} // namespace burin
