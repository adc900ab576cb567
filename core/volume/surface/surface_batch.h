// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface_field.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace burin {

/// Cubes that the surface crosses, from several rows of a field, with the values at their corners, side by side: so
/// that points are computed for whole registers of cubes, and after the rows themselves are gone.
class SurfaceBatch {
public:
    static constexpr std::size_t most = 240;
    /// This many cubes more may be read behind the last; their content is undefined.
    static constexpr std::size_t spare = 16;
    template <class Number>
    struct alignas(64) Each : std::array<Number, most + spare> {};
    /// Values at a cube's corners: each word holds nodes n and n + 1 of a column, for columns u and u + 1 of the lower
    /// row, then of the upper one.
    struct alignas(32) Corners {
        std::uint32_t values[4], smooth[4];
    };

    /// A cube of one row (`SurfaceCubes`), with the number of that row, counted from the first of the field, in the
    /// bits above its column.
    static constexpr int rowShift = 22, columnShift = 16;
    static constexpr std::uint32_t columnMask = 0x3f, placeMask = 0xffff;
    static_assert(SurfaceWindow::mostColumns <= columnMask && SurfaceField::mostPlaces <= placeMask);

    /// A row of cubes.
    struct Row {
        const std::array<SurfaceField::Row, 2>& field; ///< below and above them
        std::uint32_t number = 0;                      ///< counted from the first of the field
        int stride = 0;                                ///< from column to column
    };
    /// Adds as many cubes from the beginning of a row as there is room for. @return the remaining ones
    /// @param pointAt  receives the number of its point at the index of each cube  @param point  number of the first
    std::span<const std::uint32_t> add(std::span<const std::uint32_t> cubes, const Row& row, std::uint32_t* pointAt,
                                       std::uint32_t point) noexcept;

    std::size_t count() const noexcept { return count_; }
    bool full() const noexcept { return count_ == most; }
    void clear() noexcept { count_ = 0; }

    const Each<Corners>& corners() const noexcept { return corners_; }
    const Each<std::uint32_t>& cubes() const noexcept { return cubes_; }

private:
    Each<Corners> corners_{};
    Each<std::uint32_t> cubes_{};
    std::size_t count_ = 0;
};

} // namespace burin
