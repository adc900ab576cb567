// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface.h"

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// The surface bricks in which a workpiece shows bare part. Everything outside its grid counts as bare.
class BareBricks {
public:
    explicit BareBricks(const Grid& grid);
    /// @param bricks of the grid
    void mark(std::span<const SurfaceBrick> bricks);
    /// Whether a box extends into a marked brick or beyond the grid. @param low, high corners, mm, setup frame
    bool touches(const glm::vec3& low, const glm::vec3& high) const;
    friend bool operator==(const BareBricks& a, const BareBricks& b) { return a.marks_ == b.marks_; }

private:
    std::uint8_t& markOf(SurfaceBrick brick) { return marks_[placeOf(brick.u, brick.v, brick.n)]; }
    std::size_t placeOf(int u, int v, int n) const {
        return static_cast<std::size_t>((v * count_.x + u) * count_.z + n);
    }

    glm::ivec3 axes_;      ///< of u, v and the runs
    glm::ivec3 count_;     ///< number of bricks along `axes_`
    glm::vec3 low_, high_; ///< limits of the grid along `axes_`, mm
    float slack_;          ///< mm: tolerance for rounding of positions on a face of the grid
    float perMillimetre_;  ///< bricks per mm
    bool any_ = false;     ///< whether any brick is marked
    std::vector<std::uint8_t> marks_;
};

/// Finds the bricks in which a surface shows bare part, and the adjacent ones that are visible past its border.
/// @param mesh  all triangles of a tile at a level, not simplified
/// @param found replaced; each brick once
void findBareBricks(const VolumeSnapshot& workpiece, int level, const SurfaceMesh& mesh,
                    std::vector<SurfaceBrick>& found);

} // namespace burin
