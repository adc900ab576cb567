// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface_batch.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace burin {

/// Edges between two nodes that the surface crosses: for a batch of cubes those that start at their lowest corners.
class SurfaceEdges {
public:
    /// An edge, identified by the index of its start node; the highest bit is set if that node is inside.
    static constexpr std::uint32_t insideBit = std::uint32_t{1} << 31;
    static constexpr std::uint32_t startOf(std::uint32_t edge) { return edge & ~insideBit; }
    static constexpr std::uint32_t startsInside(std::uint32_t edge) { return edge >> 31; }

    /// @param axis  0, 1, 2: along u, v, the runs
    std::span<const std::uint32_t> listed(std::size_t axis) const { return {edges_[axis].data(), count_[axis]}; }

    /// Where to write the edges of a batch; up to `SurfaceBatch::spare` entries behind them may be overwritten.
    std::uint32_t* room(std::size_t axis) { return edges_[axis].data(); }
    /// @param ends  one past the last that was written, by axis
    void keep(const std::array<std::uint32_t*, 3>& ends) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            count_[axis] = static_cast<std::size_t>(ends[axis] - edges_[axis].data());
    }

private:
    std::array<std::array<std::uint32_t, SurfaceBatch::most + SurfaceBatch::spare>, 3> edges_;
    std::array<std::size_t, 3> count_{};
};

} // namespace burin
