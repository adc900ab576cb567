// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/dense.h"

#include "core/base/parallel.h"
#include "core/volume/runs/assembly.h"
#include "core/volume/runs/voxel_runs.h"

#include <algorithm>
#include <utility>

namespace burin {

namespace {

std::size_t voxelCount(const Grid& grid) {
    const glm::ivec3& count = grid.count();
    return static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y) * static_cast<std::size_t>(count.z);
}

std::size_t placeOf(const Grid& grid, VoxelIndex voxel) {
    const auto width = static_cast<std::size_t>(grid.count().x), depth = static_cast<std::size_t>(grid.count().y);
    return (static_cast<std::size_t>(voxel.k) * depth + static_cast<std::size_t>(voxel.j)) * width +
           static_cast<std::size_t>(voxel.i);
}

} // namespace

Result<RunVolume> fromDense(const Grid& grid, PropertyList properties, std::span<const PropertyIndex> voxels) {
    if (voxels.size() != voxelCount(grid))
        return Error{ErrorCode::argumentInvalid, "voxels", std::to_string(voxels.size()),
                     std::to_string(voxelCount(grid)) + " of them"};
    if (!voxels.empty() && std::ranges::max(voxels) >= properties.size())
        return Error{ErrorCode::argumentInvalid, "property", std::to_string(std::ranges::max(voxels)),
                     "an entry of the property list"};
    return assemble(grid, std::move(properties), [&](LineIndex line, std::vector<Segment>& segments) {
        for (std::int32_t along = 0; along < grid.voxelsPerLine(); ++along) {
            const PropertyIndex property = voxels[placeOf(grid, grid.voxel(line, along))];
            const bool last = along + 1 == grid.voxelsPerLine();
            if (last || voxels[placeOf(grid, grid.voxel(line, along + 1))] != property)
                segments.emplace_back(static_cast<RunPosition>(along + 1) * unitsPerVoxel, property);
        }
    });
}

std::vector<PropertyIndex> toDense(const VolumeSnapshot& volume) {
    const Grid& grid = volume.grid();
    std::vector<PropertyIndex> voxels(voxelCount(grid), airProperty);
    parallelFor(std::int32_t{0}, grid.lineCountV(), [&](std::int32_t v) {
        for (std::int32_t u = 0; u < grid.lineCountU(); ++u)
            forEachVoxelRun(volume.line({u, v}), [&](const Run& run) {
                for (std::int32_t along = run.first; along <= run.last; ++along)
                    voxels[placeOf(grid, grid.voxel({u, v}, along))] = run.property;
            });
    });
    return voxels;
}

} // namespace burin
