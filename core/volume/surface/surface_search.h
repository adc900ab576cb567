// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface_window.h"

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Finds the windows of a tile that contain surface: those that see both air and material. Keeps its working storage.
class SurfaceSearch {
public:
    /// Returns the indices of pieces along the runs (`SurfaceWindow::of`), rising. Examines all runs of the tile and
    /// its margin.
    std::span<const int> pieces(const VolumeSnapshot& workpiece, SurfaceTile tile, int level);

private:
    void mark(std::span<const Segment> line, RunPosition lineEnd);
    void markInterval(std::vector<int>& steps, std::int64_t from, std::int64_t to) const;

    std::int64_t cell_ = unitsPerVoxel; ///< run units
    std::vector<int> solid_, air_;      ///< by piece: change in the number of scanlines with solid or air in it, from
                                        ///< the piece before
    std::vector<int> found_;
};

} // namespace burin
