// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface_crossings.h"
#include "core/volume/surface_field.h"
#include "core/volume/surface_points.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Surface nets (Gibson 1998): one point for every cube of eight nodes that the surface crosses, in the middle of the
/// crossings on its edges, and a quadrangle around every crossed edge. A window owns the edges that start at its own
/// nodes; the points beside its border come out alike in both windows.
class SurfaceNet {
public:
    /// Works out what a window holds.
    /// @param firstPoint what triangles call the first point
    void make(const SurfaceWindow& window, const SurfaceLines& lines, const Grid& grid, std::size_t firstPoint);

    /// mm, setup frame. Behind the last `SurfaceFrame::spare` more may be read.
    std::span<const glm::vec3> points() const { return {points_.data(), pointCount_}; }
    std::span<const glm::vec3> normals() const { return {normals_.data(), pointCount_}; }
    std::span<const std::uint32_t> triangles() const {
        return {triangles_.data(), cornerCount_};
    } ///< three corners each

private:
    /// The points of a row, from 0 on, by the place of their cube; only those of cubes that are crossed are set.
    struct PointRow {
        static constexpr std::size_t before = SurfaceField::mostNodes + 1; ///< how far back faces look from a place
        std::array<std::uint32_t, before + SurfaceField::mostPlaces> points;
        std::uint32_t* data() { return points.data() + before; }
    };

    void addPoints(int row);
    void addFaces(int row);
    PointRow& pointsOf(int row) { return pointRows_[static_cast<std::size_t>(row) % 2]; }

    SurfaceField field_;
    SurfaceCrossings crossings_;
    SurfaceFrame frame_;
    std::array<PointRow, 2> pointRows_;
    // Longer than what is used of them.
    std::vector<glm::vec3> points_, normals_;
    std::vector<std::uint32_t> triangles_;
    std::size_t pointCount_ = 0, cornerCount_ = 0;
    std::uint32_t firstPoint_ = 0;
};

} // namespace burin
