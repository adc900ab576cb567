// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <cstdint>
#include <vector>

namespace burin {

/// The outline of the part seen along z, shrunk by a distance: the scanlines whose neighbours within that distance all
/// hold the part.
class ShrunkOutline {
public:
    /// @param distance mm
    ShrunkOutline(const RunVolume& workpiece, double distance);
    bool contains(double x, double y) const noexcept; ///< mm, setup frame

private:
    Grid grid_;
    std::vector<std::uint8_t> inside_; ///< by v, then by u; bytes, so that columns can be written concurrently
};

} // namespace burin
