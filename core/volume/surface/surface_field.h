// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface_lines.h"

#include <array>
#include <cstdint>

namespace burin {

/// Fill level of a workpiece around one window, on the window's lattice. Along the runs a node's value is the exact
/// share of solid within one cell to either side: around a face it falls linearly over two cells, so that linear
/// interpolation finds the face where the run ends. Across the runs values are averaged 1-2-1, to smooth the steps of
/// slanting walls. Integers, so that neighbouring windows get the same values bit for bit.
///
/// Columns and nodes count from the first of the lines' box. The field is computed row by row and holds only what cubes
/// between two rows need, so that it stays in the nearest cache.
class SurfaceField {
public:
    /// Values of a row. A column's nodes are adjacent, columns are `stride` apart.
    struct Row {
        const std::int16_t* values = nullptr; ///< share of solid minus one half: 0 is the surface; from column 1 on
        /// The same averaged once more, 1-2-1 along all axes, from column 2 and node 1 on. For the normals, because the
        /// eye takes a ripple of the normals for a ripple of the surface.
        const std::int16_t* smooth = nullptr;
        const std::uint64_t* below = nullptr; ///< by column, one bit per node: its value is below 0
    };
    /// Both must stay valid until the last row.
    void start(const SurfaceWindow& window, const SurfaceLines& lines);
    /// Computes what the next row of the lines' box adds.
    void advance();
    /// The first of the two rows between which all is known, those `delay` and `delay` - 1 behind the next row. Valid
    /// from two rows behind the box's first on.
    int row() const { return row_ - delay; }
    const std::array<Row, 2>& rowPair() const { return rowPair_; }
    int stride() const { return stride_; }

    static constexpr int mostNodes = 48, mostPlaces = SurfaceWindow::mostColumns * mostNodes; ///< of one row

private:
    static constexpr int delay = 4, padding = 16;
    static_assert(mostNodes >= SurfaceWindow::ownedNodes + 1 + 2 * SurfaceWindow::marginNodes);
    struct alignas(32) Plane {
        std::array<std::int16_t, mostPlaces + 2 * padding> nodes{};
        std::int16_t* data() { return nodes.data() + padding; }
        const std::int16_t* data() const { return nodes.data() + padding; }
    };
    Row rowAt(int row) const {
        return {values_[static_cast<std::size_t>(row) % 3].data(), smooth_[static_cast<std::size_t>(row) % 2].data(),
                below_[static_cast<std::size_t>(row) % 3].data()};
    }

    const SurfaceWindow* window_ = nullptr;
    const SurfaceLines* lines_ = nullptr;
    int row_ = 0; ///< index of the next row
    std::array<Row, 2> rowPair_;
    int stride_ = 0;
    std::array<Plane, 3> values_;
    std::array<Plane, 2> smooth_;
    std::array<std::array<std::uint64_t, SurfaceWindow::mostColumns + 2>, 3> below_{};
    Plane seen_;                      ///< of the newest row, not yet averaged
    std::array<Plane, 2> alongU_;     ///< averaged along u: the two newest rows
    Plane acrossRuns_;                ///< values averaged along u once more
    std::array<Plane, 2> alongNodes_; ///< averaged along the nodes as well, of the last two rows
};

} // namespace burin
