// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/part_field/part_asker.h"

#include <cmath>

namespace burin {

DistanceSample PartAsker::ask(const glm::dvec3& place) {
    const glm::dvec3 point = origin_ + place * voxel_;
    const double within = any_ ? glm::length(point - last_) * (1.0 + 1e-9) + 1e-9 : 1e300;
    const ClosestPoint closest = part_.closest(point, within);
    const bool found = std::isfinite(closest.distance) && closest.outward != glm::dvec3(0.0);
    if (!std::isfinite(closest.distance)) return {1e6F, glm::vec3(0.0F)};
    last_ = closest.point;
    any_ = found;
    const glm::dvec3 gradient = closest.distance > 1e-9 * voxel_ ? (point - closest.point) / closest.signedDistance
                                : found                          ? glm::normalize(closest.outward)
                                                                 : glm::dvec3(0.0);
    return {static_cast<float>(closest.signedDistance / voxel_), glm::vec3(gradient)};
}

} // namespace burin
