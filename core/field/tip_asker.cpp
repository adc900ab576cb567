// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/tip_asker.h"

#include "core/geometry/clearance_gradient.h"
#include "core/geometry/upright.h"

#include <algorithm>

namespace burin {

namespace {

constexpr float leastGain = 0.5F; // any value, as long as depths of a voxel stay out of the range that only leads
                                  // outwards

} // namespace

TipAsker::TipAsker(const MeshDistance& part, const ToolFieldRequest& request, const ClearanceTolerance& tolerance)
    : request_(request), tolerance_(tolerance), asker_(part, request.tool, uprightAxis) {}

TipSample TipAsker::ask(const glm::dvec3& tip) {
    const ToolClearance found = asker_.ask(tip, 1e300, tolerance_);
    if (!(found.clearance < farthestClearance)) return {{static_cast<float>(farthestClearance), glm::vec3(0.0F)}, 1.0F};
    const ClearanceGradient change = clearanceGradient(request_.tool, {tip, uprightAxis}, found, 0.01 * request_.voxel);
    TipSample sample{{static_cast<float>(found.clearance), glm::vec3(change.gradient)}, 1.0F};
    sample.gain = std::max(static_cast<float>(change.gain), leastGain);
    return sample;
}

} // namespace burin
