// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <cstdint>
#include <vector>

namespace burin {

/// Measures how thick stock lies along a direction: exactly to where its runs end, scanline by scanline; where all
/// scanlines of a brick hold stock, a brick at a time. Any number of threads may ask.
class LeftOver {
public:
    /// Looks at every brick (parallel). Keeps a reference to the workpiece, which must not change.
    explicit LeftOver(const RunVolume& workpiece);

    /// mm from a place along a unit direction to where the stock ends: air, or the grid's border. What is protected is
    /// passed and does not count. Starts an eighth of a voxel out; ends after `longest` mm. 0: bare.
    double along(const glm::dvec3& place, const glm::dvec3& direction, double longest) const noexcept;

private:
    /// Run units of a brick's 64 lines that all hold stock.
    struct Common {
        std::int32_t from = 0, to = 0;
    };
    Common commonOf(LineIndex corner) const;

    const RunVolume& workpiece_;
    const Grid& grid_;
    std::int32_t bricksU_ = 0;
    std::vector<Common> common_; ///< by v, then u
};

} // namespace burin
