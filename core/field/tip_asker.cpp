// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/tip_asker.h"

#include "core/geometry/supporting_plane.h"

namespace burin {

namespace {

const glm::dvec3 upright(0.0, 0.0, 1.0);
constexpr double alike = 0.98; // cosine: the mesh's normal is the direction of a contact, not the mean of two faces

} // namespace

TipAsker::TipAsker(const MeshDistance& part, const ToolFieldRequest& request, const ClearanceTolerance& tolerance)
    : request_(request), tolerance_(tolerance), asker_(part, request.tool, upright) {}

PartSample TipAsker::ask(const glm::dvec3& tip) {
    const ToolClearance found = asker_.ask(tip, 1e300, tolerance_);
    if (!(found.clearance < farthestClearance)) return {static_cast<float>(farthestClearance), glm::vec3(0.0F)};
    return {static_cast<float>(found.clearance), glm::vec3(gradientOf(found, tip))};
}

glm::dvec3 TipAsker::gradientOf(const ToolClearance& found, const glm::dvec3& tip) const noexcept {
    const double length = glm::length(found.outward);
    if (!(length > 0.0)) return found.away;
    const glm::dvec3 normal = found.outward / length;
    if (glm::dot(normal, found.away) > alike) return normal;
    if (found.clearance > 0.0) return found.away;
    // The sample is of a point that is nearly the deepest.
    return -supportingPlane(PlacedPiece(request_.tool[found.piece], {tip, upright}), found.meshPoint, normal,
                            0.01 * request_.voxel)
                .slope;
}

} // namespace burin
