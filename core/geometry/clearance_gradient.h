// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/mesh_distance.h"

namespace burin {

/// How a clearance changes with the position of the tip.
struct ClearanceGradient {
    glm::dvec3 gradient{0.0};
    /// Gain of clearance per distance that the tip moves out: less than 1 if a rim is inside, whose faces are nearer
    /// than the rim itself.
    double gain = 1.0;
};

/// The gradient of a clearance that was computed for a tool at a pose. On a ridge of the tool's distance it follows
/// from the mesh's surface, because the result itself has the slope of only one of the faces.
/// @param ridge  mm: distance from the result's point within which a ridge is considered
ClearanceGradient clearanceGradient(std::span<const RevolvedPiece> tool, const ToolPose& pose,
                                    const ToolClearance& found, double ridge) noexcept;

} // namespace burin
