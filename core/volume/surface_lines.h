// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface_box.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Where the scanlines of a window change between material and air. Everything outside the grid is air.
class SurfaceLines {
public:
    /// A change behind the first of its scanline.
    struct Further {
        int column = 0; ///< of the window
        SurfaceLine line;
    };

    void read(const VolumeSnapshot& workpiece, const SurfaceWindow& window);

    const SurfaceBox& box() const { return box_; }
    /// The scanlines of a column in a row of the window: 2^level along u, and as many rows of scanlines, `step` apart.
    const SurfaceLine* at(int row, int column) const {
        return lines_.data() + (static_cast<std::size_t>(row) << level_) * step_ +
               (static_cast<std::size_t>(column) << level_);
    }
    std::size_t step() const { return step_; }
    std::span<const Further> further(int row) const {
        const auto at = static_cast<std::size_t>(row);
        return std::span(further_).subspan(firstFurther_[at], firstFurther_[at + 1] - firstFurther_[at]);
    }
    /// The one material in the window, airProperty when there are several.
    PropertyIndex onlyProperty() const;
    /// Whether any of them is protected.
    bool holdsProtected(const PropertyList& properties) const;

private:
    class Reader;

    int level_ = 0;
    std::size_t step_ = 0;
    std::vector<SurfaceLine> lines_;
    std::vector<Further> further_;
    std::array<std::size_t, SurfaceWindow::mostColumns + 1> firstFurther_{}; ///< by row
    std::array<std::uint8_t, 256> seen_{};                                   ///< 1: the property occurs
    SurfaceBox box_;
};

} // namespace burin
