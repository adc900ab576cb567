// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/packed/volume_file.h"
#include "core/volume/runs/tile.h"

#include <cstddef>
#include <vector>

namespace burin {

/// Records which bricks of 8 × 8 scanlines a reader has read.
class BrickMap {
public:
    explicit BrickMap(const Grid& grid);

    bool has(LineIndex line) const noexcept { return present_[placeOf(line)]; }
    void add(LineIndex line);
    std::size_t count() const noexcept { return count_; }
    std::size_t all() const noexcept { return present_.size(); }
    /// Disjoint rectangles that cover the missing bricks.
    std::vector<VolumeLoss> losses() const;

private:
    std::size_t placeOf(LineIndex line) const noexcept {
        return static_cast<std::size_t>(line.v / tileSide) * static_cast<std::size_t>(bricksU_) +
               static_cast<std::size_t>(line.u / tileSide);
    }
    VolumeLoss lossOf(std::int32_t lowU, std::int32_t lowV, std::int32_t highU, std::int32_t highV) const;

    Grid grid_;
    std::int32_t bricksU_, bricksV_;
    std::vector<bool> present_;
    std::size_t count_ = 0;
};

} // namespace burin
