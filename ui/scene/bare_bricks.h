// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface.h"

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Where a workpiece shows bare part, by surface bricks; and everywhere outside of its grid.
class BareBricks {
public:
    explicit BareBricks(const Grid& grid);
    /// @param bricks of the grid
    void mark(std::span<const SurfaceBrick> bricks);
    /// Whether a box reaches into a marked brick or beyond the grid. @param low, high corners, mm, setup frame
    bool touches(const glm::vec3& low, const glm::vec3& high) const;
    friend bool operator==(const BareBricks& a, const BareBricks& b) { return a.marks_ == b.marks_; }

private:
    std::uint8_t& markOf(SurfaceBrick brick) { return marks_[placeOf(brick.u, brick.v, brick.n)]; }
    std::size_t placeOf(int u, int v, int n) const {
        return static_cast<std::size_t>((v * count_.x + u) * count_.z + n);
    }

    glm::ivec3 axes_;      ///< of u, v and the runs
    glm::ivec3 count_;     ///< bricks along them
    glm::vec3 low_, high_; ///< the grid's, along them, mm
    float slack_;          ///< mm: rounded off, a face of the grid lies in it
    float perMillimetre_;  ///< bricks
    bool any_ = false;     ///< is marked
    std::vector<std::uint8_t> marks_;
};

/// The bricks in which a surface shows bare part, and those beside that are seen past its border.
/// @param mesh  all triangles of a tile at a level, not simplified
/// @param found replaced; each brick once
void findBareBricks(const VolumeSnapshot& workpiece, int level, const SurfaceMesh& mesh,
                    std::vector<SurfaceBrick>& found);

} // namespace burin
