// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface_box.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Where the scanlines of a window change between material and air. Everything outside the grid is air. Refers to the
/// workpiece that was read, which must stay valid.
class SurfaceLines {
public:
    /// A change behind the first one of its scanline.
    struct Further {
        int row = 0, column = 0; ///< of the window
        SurfaceLine line;
    };

    void read(const VolumeSnapshot& workpiece, const SurfaceWindow& window);

    const SurfaceBox& box() const { return box_; }
    /// The scanlines of a column in a row of the window: 2^level along u, and equally many rows of scanlines, `step`
    /// apart.
    const SurfaceLine* at(int row, int column) const {
        return lines_.data() + (static_cast<std::size_t>(row) << level_) * step_ +
               (static_cast<std::size_t>(column) << level_);
    }
    std::size_t step() const { return step_; }
    std::span<const Further> further(int row) const {
        const auto at = static_cast<std::size_t>(row);
        return std::span(further_).subspan(firstFurther_[at], firstFurther_[at + 1] - firstFurther_[at]);
    }
    /// Returns the material at a position, within the range that the window covers; air outside the grid. A copy of the
    /// necessary pointers, so that the compiler knows that no store into properties can change them.
    class Materials {
    public:
        explicit Materials(const SurfaceLines& lines)
            : firstSegments_(lines.firstSegments_.data()), lineEnd_(lines.lineEnd_) {}
        /// @param line      row after row of scanlines, `step` apart, from the window's first on
        /// @param position  run units
        PropertyIndex at(std::int32_t line, std::int32_t position) const {
            const Segment* segment = firstSegments_[line];
            if (segment == nullptr || position >= lineEnd_) return airProperty;
            while (static_cast<std::int32_t>(segment->end()) <= position) ++segment;
            return segment->property();
        }

    private:
        const Segment* const* firstSegments_;
        std::int32_t lineEnd_;
    };
    /// The single material in the window, or airProperty if there are several.
    PropertyIndex onlyProperty() const;
    /// Whether any of them is protected.
    bool holdsProtected(const PropertyList& properties) const;

private:
    class Reader;
    template <class Visit>
    void eachMaterial(Visit visit) const;

    int level_ = 0;
    std::size_t step_ = 0;
    std::int32_t lineEnd_ = 0;
    std::vector<SurfaceLine> lines_;
    std::vector<const Segment*> firstSegments_; ///< by scanline: the first that ends within the window or behind it
    std::vector<Further> further_;
    std::array<std::size_t, SurfaceWindow::mostColumns + 1> firstFurther_{}; ///< by row
    std::array<std::uint8_t, 256> seen_{};                                   ///< 1: the property occurs
    SurfaceBox box_;
};

} // namespace burin
