// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/geometry/mesh_distance.h"

#include <cstdint>
#include <vector>

namespace burin::benchmarks {

/// A ball as a shell of points in a map of voxels (McNeely, Puterbaugh & Troy 1999). Each point that is in a voxel of
/// the part's surface, or of a layer before it, is pushed out along its own normal by its depth below the plane through
/// that voxel's centre. The sum, divided by a tenth of their number if ten or more touch, is balanced by the coupling
/// to the hand. The coupling is limited to the force of half a voxel of contact, and the ball moves by at most half a
/// voxel per tick. There are two layers before the surface, which the paper uses against overlap. Single-threaded.
class PointShell {
public:
    struct Settings {
        double radius = 3.0;    ///< mm
        int points = 10'000;    ///< on the lower half
        double voxel = 0.25;    ///< mm
        double stiffness = 2.0; ///< N/mm, of each point
        double coupling = 1.0;  ///< N/mm, to the hand
    };
    /// @param region  extent of the map, mm
    PointShell(const MeshDistance& part, const Box& region, const Settings& settings);
    void place(const glm::dvec3& centre) { centre_ = centre; }
    const glm::dvec3& advance(const glm::dvec3& goal);

private:
    std::uint8_t layerAt(const glm::ivec3& voxel) const noexcept;

    Settings settings_;
    glm::dvec3 low_;
    glm::ivec3 count_;
    std::vector<std::uint8_t> layers_; ///< 0: free; 1, 2: before the surface; 3: inside
    std::vector<glm::dvec3> shell_;    ///< unit vectors from the centre
    glm::dvec3 centre_{0.0};
};

} // namespace burin::benchmarks
