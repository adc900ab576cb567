// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/clearance_gradient.h"

#include "core/geometry/supporting_plane.h"

namespace burin {

namespace {

constexpr double alike = 0.98; // cosine: the mesh's normal is the direction of a contact, not the mean of two faces

} // namespace

ClearanceGradient clearanceGradient(std::span<const RevolvedPiece> tool, const ToolPose& pose,
                                    const ToolClearance& found, double ridge) noexcept {
    ClearanceGradient answer{found.away, 1.0};
    const double length = glm::length(found.outward);
    if (!(length > 0.0)) return answer;
    const glm::dvec3 normal = found.outward / length;
    // On the tool, or where the mesh is deepest in it. The point is only approximately the deepest, so a ridge may pass
    // near it.
    const bool inside = found.clearance <= 0.0;
    const glm::dvec3 place = inside ? found.meshPoint : found.meshPoint + found.clearance * found.away;
    const glm::dvec3 slope = supportingPlane(PlacedPiece(tool[found.piece], pose), place, normal, ridge).slope;
    answer.gain = glm::length(slope);
    if (inside)
        answer.gradient = -slope;
    else if (glm::dot(normal, found.away) > alike)
        answer.gradient = normal;
    return answer;
}

} // namespace burin
