// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/geometry/box.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace burin {

/// Position of a voxel in its grid, from 0: a count along x, y and z of the setup frame, not a length.
/// (The paper counts from 1.)
struct VoxelIndex {
    std::int32_t i = 0, j = 0, k = 0;
    friend constexpr bool operator==(VoxelIndex, VoxelIndex) = default;
};

/// Axis that the runs of a volume are parallel to.
enum class RunAxis : std::uint8_t { x, y, z };

/// A scanline, given by its position across the run axis. For runs along z, u counts along x and v along y; the other
/// axes follow by cyclic exchange (runs along x: u = y, v = z; along y: u = z, v = x).
struct LineIndex {
    std::int32_t u = 0, v = 0;
    friend constexpr bool operator==(LineIndex, LineIndex) = default;
};

/// Position on a scanline in 1/256 voxel from the low end of the grid: fixed point, so that sums are exact.
using RunPosition = std::uint32_t;
inline constexpr RunPosition unitsPerVoxel = 256;

/// Where a grid of cubic voxels lies in the setup frame; the only place where a length becomes an index.
class Grid {
public:
    static constexpr std::int32_t maximumVoxelsPerAxis = 32768;

    /// @param low   corner of voxel (0, 0, 0), mm
    /// @param edge  of a voxel, mm
    /// @param count voxels along x, y, z
    /// Errors: argumentInvalid (edge not finite or not > 0), volumeTooLarge (an axis beyond 1 … 32,768 voxels).
    static Result<Grid> make(const glm::dvec3& low, double edge, const glm::ivec3& count, RunAxis axis = RunAxis::z);

    const glm::dvec3& low() const noexcept { return low_; }     ///< mm, setup frame
    double edge() const noexcept { return edge_; }              ///< mm
    const glm::ivec3& count() const noexcept { return count_; } ///< voxels along x, y, z
    RunAxis axis() const noexcept { return axis_; }
    /// mm, setup frame.
    Box box() const noexcept { return {low_, low_ + glm::dvec3(count_) * edge_}; }

    /// Index (0, 1, 2 for x, y, z) of the axis of u, of v and of the runs.
    int axisOfU() const noexcept { return (static_cast<int>(axis_) + 1) % 3; }
    int axisOfV() const noexcept { return (static_cast<int>(axis_) + 2) % 3; }
    int axisOfRuns() const noexcept { return static_cast<int>(axis_); }

    /// Number of scanlines along u and v, and number of voxels on one; `lineEnd` in run units (1/256 voxel).
    std::int32_t lineCountU() const noexcept { return count_[axisOfU()]; }
    std::int32_t lineCountV() const noexcept { return count_[axisOfV()]; }
    std::int32_t voxelsPerLine() const noexcept { return count_[axisOfRuns()]; }
    RunPosition lineEnd() const noexcept { return static_cast<RunPosition>(voxelsPerLine()) * unitsPerVoxel; }

    /// Volume of one run unit (1/256 voxel on one scanline), mm³.
    double unitVolume() const noexcept { return edge_ * edge_ * edge_ / unitsPerVoxel; }

    /// Coordinates of a scanline's centre across the run axis (along the axes of u and v), mm.
    glm::dvec2 lineCentre(LineIndex line) const noexcept {
        return {low_[axisOfU()] + (line.u + 0.5) * edge_, low_[axisOfV()] + (line.v + 0.5) * edge_};
    }
    /// Position of `along` (mm, along the run axis) on a scanline, rounded to the nearest unit, clamped to the grid.
    RunPosition toRunPosition(double along) const noexcept;
    /// Coordinate along the run axis of a position on a scanline, mm.
    double toMillimetres(RunPosition position) const noexcept {
        return low_[axisOfRuns()] + edge_ * (static_cast<double>(position) / unitsPerVoxel);
    }
    /// The scanline that a voxel lies on and its index along it, and the inverse. Indices outside the grid are not
    /// rejected.
    LineIndex lineOf(VoxelIndex voxel) const noexcept;
    std::int32_t alongOf(VoxelIndex voxel) const noexcept;
    VoxelIndex voxel(LineIndex line, std::int32_t along) const noexcept;
    bool contains(VoxelIndex voxel) const noexcept;
    bool contains(LineIndex line) const noexcept {
        return line.u >= 0 && line.v >= 0 && line.u < lineCountU() && line.v < lineCountV();
    }

private:
    glm::dvec3 low_{0.0};
    double edge_ = 1.0;
    glm::ivec3 count_{1};
    RunAxis axis_ = RunAxis::z;
};

} // namespace burin
