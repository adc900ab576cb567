// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/peers/point_shell.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace burin::benchmarks {

namespace {

constexpr double layersBefore = 2.0; // voxels

/// Directions spread evenly over the lower half of the unit sphere: Fibonacci lattice.
std::vector<glm::dvec3> lowerHalf(int count) {
    const double golden = pi * (3.0 - std::sqrt(5.0));
    std::vector<glm::dvec3> points;
    for (int i = 0; i < count; ++i) {
        const double z = -(i + 0.5) / count, across = std::sqrt(1.0 - z * z), turn = golden * i;
        points.emplace_back(across * std::cos(turn), across * std::sin(turn), z);
    }
    return points;
}

glm::dvec3 limited(const glm::dvec3& vector, double most) {
    const double length = glm::length(vector);
    return length > most ? vector * (most / length) : vector;
}

} // namespace

PointShell::PointShell(const MeshDistance& part, const Box& region, const Settings& settings)
    : settings_(settings)
    , low_(region.low)
    , count_(glm::ceil((region.high - region.low) / settings.voxel))
    , layers_(static_cast<std::size_t>(count_.x) * static_cast<std::size_t>(count_.y) *
              static_cast<std::size_t>(count_.z))
    , shell_(lowerHalf(settings.points)) {
    std::size_t slot = 0;
    for (int z = 0; z < count_.z; ++z)
        for (int y = 0; y < count_.y; ++y)
            for (int x = 0; x < count_.x; ++x) {
                const glm::dvec3 centre = low_ + settings_.voxel * (glm::dvec3(x, y, z) + 0.5);
                const double far = (layersBefore + 1.0) * settings_.voxel;
                const double distance = part.closest(centre, far).signedDistance / settings_.voxel;
                const double before = layersBefore - distance; // voxels into the layers
                layers_[slot++] = static_cast<std::uint8_t>(std::clamp(std::ceil(before), 0.0, layersBefore + 1.0));
            }
}

std::uint8_t PointShell::layerAt(const glm::ivec3& voxel) const noexcept {
    if (glm::any(glm::lessThan(voxel, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(voxel, count_))) return 0;
    const auto width = static_cast<std::size_t>(count_.x), rows = static_cast<std::size_t>(count_.y);
    return layers_[(static_cast<std::size_t>(voxel.z) * rows + static_cast<std::size_t>(voxel.y)) * width +
                   static_cast<std::size_t>(voxel.x)];
}

const glm::dvec3& PointShell::advance(const glm::dvec3& goal) {
    glm::dvec3 force(0.0);
    int touching = 0;
    for (const glm::dvec3& outward : shell_) {
        const glm::dvec3 point = centre_ + settings_.radius * outward;
        const glm::ivec3 voxel(glm::floor((point - low_) / settings_.voxel));
        const std::uint8_t layer = layerAt(voxel);
        if (layer == 0) continue;
        const glm::dvec3 middle = low_ + settings_.voxel * (glm::dvec3(voxel) + 0.5);
        // Deeper layers start where the previous one ends, so that the force is continuous there.
        const double depth = glm::dot(point - middle, outward) + settings_.voxel * (layer - 0.5);
        if (!(depth > 0.0)) continue;
        force -= settings_.stiffness * depth * outward;
        ++touching;
    }
    if (touching >= 10) force *= 10.0 / touching;
    const double half = 0.5 * settings_.voxel, stiffness = settings_.stiffness * std::min(10, touching);
    const glm::dvec3 coupling = limited(settings_.coupling * (goal - centre_), touching > 0 ? half * stiffness : 1e9);
    centre_ += limited((coupling + force) / (settings_.coupling + stiffness), half);
    return centre_;
}

} // namespace burin::benchmarks
