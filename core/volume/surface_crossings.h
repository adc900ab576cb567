// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface_field.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace burin {

/// Cubes of eight nodes, and edges between two, that the surface crosses and whose lowest node lies in one row of a
/// field. They are told by whole words, a bit a node, and listed without a branch that depends on the shape.
class SurfaceCrossings {
public:
    /// A cube by its lowest node: in the upper half its column, in the lower half the node's place in its row of the
    /// field.
    static constexpr std::uint32_t columnOf(std::uint32_t cube) { return cube >> 16; }
    static constexpr std::uint32_t placeOf(std::uint32_t cube) { return cube & 0xffff; }
    /// An edge by the place of the node it starts at, and in the highest bit whether that is inside.
    static constexpr std::uint32_t startOf(std::uint32_t edge) { return edge & 0x7fffffff; }
    static constexpr std::uint32_t startsInside(std::uint32_t edge) { return edge >> 31; }
    /// There are always so many cubes and edges that are written but not listed.
    static constexpr std::size_t spare = 8;

    /// What is looked for.
    struct Owned {
        int firstColumn = 0, endColumn = 0; ///< cubes
        int firstEdgeColumn = 0;            ///< edges, up to the same column
        std::uint64_t cubes = 0, nodes = 0; ///< cubes by their lowest node, edges by that which they start at
    };

    /// @param rows   the one that is looked at and the next; neither is read after
    /// @param stride from column to column
    /// @param edges  whether edges are wanted, too
    void find(const std::array<SurfaceField::Row, 2>& rows, int stride, const Owned& owned, bool edges);

    std::span<const std::uint32_t> cubes() const { return {cubes_.data(), cubeCount_}; }
    /// @param axis 0, 1, 2: along u, v, the runs
    std::span<const std::uint32_t> edges(std::size_t axis) const { return {edges_[axis].data(), edgeCount_[axis]}; }

private:
    static constexpr std::size_t mostPlaces = SurfaceField::mostPlaces + spare;
    std::array<std::uint32_t, mostPlaces> cubes_;
    std::array<std::array<std::uint32_t, mostPlaces>, 3> edges_;
    std::size_t cubeCount_ = 0;
    std::array<std::size_t, 3> edgeCount_{};
};

} // namespace burin
