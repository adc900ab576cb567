// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/surface_fit.h"
#include "core/volume/surface/surface.h"

#include <optional>
#include <vector>

namespace burin {

/// The point of a workpiece's surface at full detail that is nearest to a given one, mm, setup frame.
/// @return empty if the workpiece is all air, or the point is not finite
/// Cost     grows with the bricks that are no farther than the surface.
std::optional<SurfacePoint> nearestOnSurface(const VolumeSnapshot& workpiece, const glm::dvec3& place);

/// The points of a workpiece's surface at full detail around a place, about one per crossed voxel, and which of them
/// are neighbours.
class SurfacePatch {
public:
    /// @param place  mm, setup frame  @param reach  mm: points farther than this are left out
    SurfacePatch(const VolumeSnapshot& workpiece, const glm::dvec3& place, double reach);

    const std::vector<SurfacePoint>& points() const noexcept { return points_; }
    /// The points within 1.9 voxels of a point, mostly those of the same face.
    std::span<const std::uint32_t> neighbours(std::uint32_t point) const noexcept;
    /// The point that is nearest to a place; empty if there is none.
    std::optional<std::uint32_t> nearest(const glm::dvec3& place) const noexcept;

    /// The points that are connected to `start` through steps that `accept(from, to)` takes, `start` included.
    template <typename Accept>
    std::vector<std::uint32_t> connected(std::uint32_t start, const Accept& accept) const {
        std::vector<std::uint32_t> found{start};
        std::vector<bool> seen(points_.size(), false);
        seen[start] = true;
        for (std::size_t next = 0; next < found.size(); ++next)
            for (const std::uint32_t other : neighbours(found[next])) {
                if (seen[other] || !accept(points_[found[next]], points_[other])) continue;
                seen[other] = true;
                found.push_back(other);
            }
        return found;
    }

private:
    void gather(const VolumeSnapshot& workpiece, const glm::dvec3& place, double reach);
    void link(double within);

    std::vector<SurfacePoint> points_;
    std::vector<std::uint32_t> first_, neighbours_; ///< of point i: first_[i] … first_[i + 1]
};

} // namespace burin
