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

/// The data of the deviation map: samples over the part and the tolerance by which they are judged.
struct DeviationPicture {
    std::shared_ptr<const std::vector<DeviationSample>> samples; ///< null: nothing to show
    DeviationTolerance tolerance;
    double spacing = 1.0; ///< mm: approximate distance between samples, > 0
};

/// The part's surface in the colours of its deviation, subdivided finely enough to show the samples.
struct DeviationSurface {
    ShadedMesh mesh;                       ///< contains only the measured triangles
    std::vector<DeviationColour> colours;  ///< one per point
    std::vector<std::uint32_t> unmeasured; ///< three corners each: no sample nearby, or too much stock out of reach
};

/// Takes some tenths of a second for a large part: call on a worker thread. Subdivides to about 200,000 triangles at
/// most, unless the part itself has more: beyond that the surface is coarser than the samples and shows their means.
DeviationSurface deviationSurface(const Model& part, const DeviationPicture& picture);

/// The mesh with its edges halved until none is longer than `edge` mm; no gaps open between neighbouring triangles.
ShadedMesh divided(ShadedMesh mesh, double edge);

} // namespace burin
