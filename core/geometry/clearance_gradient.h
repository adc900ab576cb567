// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/mesh_distance.h"

namespace burin {

/// How a clearance changes with the tip.
struct ClearanceGradient {
    glm::dvec3 gradient{0.0};
    /// How much of the tip's way out is gained in clearance: less than 1 where a rim is inside, whose faces are nearer
    /// than the rim is.
    double gain = 1.0;
};

/// Of a clearance that was answered for a tool at a pose: on a ridge of the tool's distance the one that the mesh's
/// surface tells, where the answer itself knows the slope of one face only.
/// @param ridge  mm: how far from the answer's point a ridge may pass
ClearanceGradient clearanceGradient(std::span<const RevolvedPiece> tool, const ToolPose& pose,
                                    const ToolClearance& found, double ridge) noexcept;

} // namespace burin
