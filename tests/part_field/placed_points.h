// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace burin {

/// The position of a field's layers in the form used for registers: the coordinates in the order in which they follow
/// each other in points.
struct FieldFrame {
    std::array<double, 10> origin;       ///< x y z x y z x y z x, mm
    double perVoxel;                     ///< 1/mm
    std::array<std::uint32_t, 3> voxels; ///< along each axis

    FieldFrame(const glm::dvec3& low, const glm::ivec3& count, double scale) noexcept : perVoxel(scale) {
        for (std::size_t i = 0; i < origin.size(); ++i) origin[i] = low[static_cast<int>(i % 3)];
        for (int axis = 0; axis < 3; ++axis)
            voxels[static_cast<std::size_t>(axis)] = std::min(static_cast<std::uint32_t>(count[axis]), mostVoxels);
    }
    static constexpr std::uint32_t mostVoxels = 1U << 19; ///< placing supports at most this many
};

/// The cells that contain points, as arrays over the points.
struct PlacedPoints {
    static constexpr std::size_t most = 256, together = 8; ///< number of points placed at a time
    template <class Number>
    struct alignas(64) Row : std::array<Number, most> {};

    std::array<Row<float>, 3> share;        ///< position within the cell
    std::array<Row<float>, 3> along;        ///< voxels from the brick's lowest corner
    std::array<Row<std::int32_t>, 3> brick; ///< counted from the origin
    Row<std::int32_t> first;                ///< of the cell's samples in the brick
    /// A bit for each point in another brick than the previous point; set for the first point of all.
    std::array<std::uint8_t, most / together> begins;
};

/// Finds the cells of points. The position in a cell has an error of at most 2^-24 cell, and a point within 2^-33 cell
/// of a cell's border may be assigned to either cell: the values of both are within the field's bound there.
/// @param count a multiple of `PlacedPoints::together`, at most `PlacedPoints::most`
/// @return whether all points are in the box of the layers; if not, `placed` must not be used
bool placePoints(const glm::dvec3* points, std::size_t count, const FieldFrame& frame, PlacedPoints& placed) noexcept;

} // namespace burin
