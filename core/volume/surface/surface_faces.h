// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace burin {

/// Where to look the corners of the quadrangles around edges up: each is the point at the place of the edge's start in
/// one of these. Counter-clockwise as seen from the far end of an edge that starts inside.
using QuadrangleCorners = std::array<const std::uint32_t*, 4>;

/// Two triangles for each crossed edge (`SurfaceEdges`): the quadrangle around it, split along its shorter diagonal.
/// Corners are looked up as edges come, triangles are written for many of them at once.
class SurfaceFaces {
public:
    /// Looks the corners of the first so many edges up as there is room for. @return the other edges
    /// @param points mm; behind the last there is room for one more number
    std::span<const std::uint32_t> lookUp(std::span<const std::uint32_t> edges, const QuadrangleCorners& corners,
                                          const glm::vec3* points) noexcept;
    bool full() const noexcept { return count_ == most; }
    /// Corners of the triangles that are to be written, and of some more that there has to be room for.
    std::size_t cornerCount() const noexcept { return 6 * count_; }
    static constexpr std::size_t spareCorners = 6 * 3;
    /// Writes the triangles of all that was looked up, which is forgotten.
    void write(std::uint32_t* triangles) noexcept;

    struct alignas(16) Corners {
        std::uint32_t at[4]; ///< numbers of points, counter-clockwise as seen from outside
    };
    /// The squares of what the diagonals go along x, y and z, the one from the second corner less the one from the
    /// first, and one number more that means nothing.
    struct alignas(16) Difference {
        float of[4];
    };

private:
    static constexpr std::size_t most = 256; ///< they stay in the nearest cache
    std::array<Corners, most> corners_;
    std::array<Difference, most> differences_;
    std::size_t count_ = 0;
};

} // namespace burin
