// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model.h"
#include "core/verify/deviation_scale.h"
#include "ui/scene/shaded_mesh.h"

#include <array>
#include <memory>
#include <vector>

namespace burin {

/// What the deviation map shows: samples over the part and how they are judged.
struct DeviationPicture {
    std::shared_ptr<const std::vector<DeviationSample>> samples; ///< null: there is nothing to show
    DeviationTolerance tolerance;
    double spacing = 1.0; ///< mm: about as far as the samples are apart, > 0
};

/// The part's surface in the colours of its deviation, divided so finely that the samples show.
struct DeviationSurface {
    ShadedMesh mesh;                       ///< its triangles are those that were measured
    std::vector<DeviationColour> colours;  ///< a point each
    std::vector<std::uint32_t> unmeasured; ///< three corners each: no sample is near, or too much is left out of reach
};

/// Takes some tenths of a second for a large part: for a worker thread. At most about 200,000 triangles where the
/// part's own are fewer: beyond that the surface is coarser than the samples, and shows their means.
DeviationSurface deviationSurface(const Model& part, const DeviationPicture& picture);

/// A mesh whose edges are all halved until none is longer than `edge` mm; no gap opens between neighbours.
ShadedMesh divided(ShadedMesh mesh, double edge);

} // namespace burin
