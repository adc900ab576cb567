// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface_field.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace burin {

/// Cubes of eight nodes that the surface crosses and whose lowest node lies in one row of a field. Found by operations
/// on whole words, one bit per node, and listed without a branch that depends on the shape.
class SurfaceCubes {
public:
    /// A cube, identified by its lowest node: its column in the upper half, the node's index in its row of the field in
    /// the lower half.
    static constexpr std::uint32_t cube(std::uint32_t column, std::uint32_t place) { return column << 16 | place; }
    static constexpr std::uint32_t placeOf(std::uint32_t cube) { return cube & 0xffff; }

    /// The range to search.
    struct Owned {
        int firstColumn = 0, endColumn = 0;
        std::uint64_t nodes = 0; ///< one bit each: lowest nodes
    };

    /// @param rows    the row to search and the next one; neither is read after the call
    /// @param stride  from column to column
    void find(const std::array<SurfaceField::Row, 2>& rows, int stride, const Owned& owned);
    std::span<const std::uint32_t> listed() const { return {cubes_.data(), count_}; }

private:
    static constexpr std::size_t spare = 2; ///< this many entries behind the listed ones may be written
    std::array<std::uint32_t, SurfaceField::mostPlaces + spare> cubes_;
    std::size_t count_ = 0;
};

} // namespace burin
