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

/// The colours of a surface's points by the stock that is left on the part there, on the deviation map's scale: the
/// distance to the part, as the mesh of both says. Where the workpiece is bare part, nothing is left.
/// The surface is divided first, where a triangle would hide how the stock changes across it: edges in reach of the
/// scale are at most 16 cells long, and those of more than two whose middle differs from their ends' mean by a fifth of
/// a band are halved. It does not move.
/// @param cell mm, of the surface, > 0
/// Any thread. Cost: some microseconds a point within reach.
std::vector<DeviationColour> colourByExcess(SurfaceMesh& mesh, const PropertyList& properties,
                                            const ExcessColours& left, double cell);

} // namespace burin
