// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <memory>

namespace burin::benchmarks {

inline constexpr std::int32_t flyingBrickSide = 32; ///< voxels

/// A cube of 32 × 32 × 32 voxels: scanlines u … u + 31, v … v + 31, and voxels from `along` on.
struct Brick {
    std::int32_t u = 0, v = 0, along = 0;
};

/// VTK's flying edges on a brick of a volume. The samples are material or none at the voxels' centres, including one
/// more layer of voxels on all sides.
class FlyingEdges {
public:
    enum class Kind : std::uint8_t { discrete, continuous }; ///< vtkDiscreteFlyingEdges3D, vtkFlyingEdges3D
    explicit FlyingEdges(Kind kind);
    ~FlyingEdges();
    FlyingEdges(const FlyingEdges&) = delete;
    FlyingEdges& operator=(const FlyingEdges&) = delete;

    /// Converts runs to samples.
    void expand(const VolumeSnapshot& volume, const Brick& brick);
    /// Converts samples to triangles. @return  their number
    std::int64_t mesh();

private:
    class Filter;
    std::unique_ptr<Filter> filter_;
};

} // namespace burin::benchmarks
