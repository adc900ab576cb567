// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/tip_asker.h"

#include "core/geometry/supporting_plane.h"

#include <algorithm>

namespace burin {

namespace {

const glm::dvec3 upright(0.0, 0.0, 1.0);
constexpr double alike = 0.98;    // cosine: the mesh's normal is the direction of a contact, not the mean of two faces
constexpr float leastGain = 0.5F; // any will do, as long as depths of a voxel do not look like what only leads out

} // namespace

TipAsker::TipAsker(const MeshDistance& part, const ToolFieldRequest& request, const ClearanceTolerance& tolerance)
    : request_(request), tolerance_(tolerance), asker_(part, request.tool, upright) {}

TipSample TipAsker::ask(const glm::dvec3& tip) {
    const ToolClearance found = asker_.ask(tip, 1e300, tolerance_);
    if (!(found.clearance < farthestClearance)) return {{static_cast<float>(farthestClearance), glm::vec3(0.0F)}, 1.0F};
    TipSample sample{{static_cast<float>(found.clearance), glm::vec3(found.away)}, 1.0F};
    const double length = glm::length(found.outward);
    if (!(length > 0.0)) return sample;
    const glm::dvec3 normal = found.outward / length;
    // On the tool, or where the mesh is deepest in it. It is nearly the deepest point only, so a ridge may pass beside
    // it.
    const bool inside = found.clearance <= 0.0;
    const glm::dvec3 place = inside ? found.meshPoint : found.meshPoint + found.clearance * found.away;
    const glm::dvec3 slope =
        supportingPlane(PlacedPiece(request_.tool[found.piece], {tip, upright}), place, normal, 0.01 * request_.voxel)
            .slope;
    sample.gain = std::max(static_cast<float>(glm::length(slope)), leastGain);
    if (inside)
        sample.clearance.gradient = glm::vec3(-slope);
    else if (glm::dot(normal, found.away) > alike)
        sample.clearance.gradient = glm::vec3(normal);
    return sample;
}

} // namespace burin
