// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/mesh_distance.h"
#include "core/verify/deviation_scale.h"
#include "core/volume/surface/surface.h"

#include <memory>
#include <vector>

namespace burin {

/// What a workpiece's surface is coloured by: how far it stands from the part.
struct ExcessColours {
    std::shared_ptr<const MeshDistance> part; ///< setup frame, mm; never null
    DeviationTolerance tolerance;

    DeviationScale scale() const { return DeviationScale(tolerance, DeviationScale::Reach::milling); }
    friend bool operator==(const ExcessColours&, const ExcessColours&) = default;
};

/// How finely a surface is divided for its colours: edges in reach of the scale are no longer than `longest`, and those
/// longer than `shortest` are halved where their middle differs from what would be drawn there by `unlike`.
struct ExcessDetail {
    double cell = 0.0;                    ///< mm, of the surface, > 0
    double shortest = 0.0, longest = 0.0; ///< mm
    double unlike = 0.0;                  ///< bands of the scale

    /// @param moving it is drawn while things move: fewer triangles
    static ExcessDetail of(double cell, bool moving) {
        return moving ? ExcessDetail{cell, 4.0 * cell, 32.0 * cell, 0.5}
                      : ExcessDetail{cell, 2.0 * cell, 16.0 * cell, 0.2};
    }
};

/// The colours of a surface's points by the stock that is left on the part there: the distance to the part, as the mesh
/// of both says. Where the workpiece is bare part, nothing is left. The surface is divided first, where a triangle
/// would hide how the stock changes across it. It does not move. Any thread. Cost: some microseconds a point within
/// reach.
std::vector<DeviationColour> colourByExcess(SurfaceMesh& mesh, const PropertyList& properties,
                                            const ExcessColours& left, const ExcessDetail& detail);

} // namespace burin
