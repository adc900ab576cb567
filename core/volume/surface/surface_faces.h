// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace burin {

/// Where to look up the corners of the quadrilaterals around edges: each corner is the point at the index of the edge's
/// start node in one of these arrays. Counter-clockwise as seen from the far end of an edge that starts inside.
using QuadrangleCorners = std::array<const std::uint32_t*, 4>;

/// Two triangles for each crossed edge (`SurfaceEdges`): the quadrilateral around it, split along its shorter diagonal.
/// Corners are looked up as edges come; triangles are written for many of them at once.
class SurfaceFaces {
public:
    /// Looks up the corners of as many edges from the beginning as there is room for. @return the remaining edges
    /// @param points  mm; one more number must be readable behind the last
    std::span<const std::uint32_t> lookUp(std::span<const std::uint32_t> edges, const QuadrangleCorners& corners,
                                          const glm::vec3* points) noexcept;
    bool full() const noexcept { return count_ == most; }
    /// Number of triangle corners to write, without `spareCorners`, for which there must be room as well.
    std::size_t cornerCount() const noexcept { return 6 * count_; }
    static constexpr std::size_t spareCorners = 6 * 3;
    /// Writes the triangles of all edges that were looked up, and forgets these.
    void write(std::uint32_t* triangles) noexcept;

    struct alignas(16) Corners {
        std::uint32_t at[4]; ///< numbers of points, counter-clockwise as seen from outside
    };
    /// The squared components of the diagonals along x, y and z, those from the second corner minus those from the
    /// first, and one more number that is meaningless.
    struct alignas(16) Difference {
        float of[4];
    };

private:
    static constexpr std::size_t most = 256; ///< small enough for the nearest cache
    std::array<Corners, most> corners_;
    std::array<Difference, most> differences_;
    std::size_t count_ = 0;
};

} // namespace burin
