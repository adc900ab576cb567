// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/sample_grid.h"
#include "tests/part_field/part_asker.h"
#include "tests/part_field/part_field_layers.h"

#include <span>

namespace burin {

/// The triangles of a mesh that are or could be nearest to some point of a cell, a cube of one voxel. Not thread-safe:
/// use one object per thread.
class CellTriangles {
public:
    static constexpr std::size_t most = 64; ///< largest number of triangles in the list of an exact cell

    CellTriangles(const MeshDistance& part, const glm::dvec3& origin, double voxel) noexcept
        : part_(part), asker_(part, origin, voxel), origin_(origin), voxel_(voxel) {}

    /// @param centre the cell's centre, voxels from the origin
    void find(const glm::dvec3& centre);
    /// As `find`; where the surface folds, only those triangles that may be nearest in an eighth of the cell.
    /// @return whether the surface folds, as `isFolded` defines it
    bool findFold(const glm::dvec3& centre, float cosine);

    /// Largest change of the distance, voxels, by a fold where none was searched for: in cells that are far from the
    /// surface and in those with too many triangles around them (the square of its half width over twice the distance).
    /// 0 where `findFold` did search.
    float unseen() const noexcept;
    /// Whether the surface folds within two and a half voxels, so that a gap or a wall may lie between samples.
    /// @param cosine of the largest angle between the normals of two triangles of an unfolded surface
    bool isFolded(float cosine);
    /// The triangles found: their numbers, rising; empty if there are more than `most`.
    std::span<const std::uint32_t> numbers();

private:
    struct Near {
        std::uint32_t number = 0;
        bool wanted = false;
        glm::vec3 normal{0.0F}; ///< zero for a triangle without area
        glm::vec3 place{0.0F};  ///< nearest point to the cell's centre, voxels from there
        double away = 0.0;      ///< its distance from the cell's centre, mm
    };

    void gather(const glm::dvec3& centre);
    void keepInEighths();
    static bool fold(const Near& a, const Near& b, float cosine) noexcept;

    const MeshDistance& part_;
    PartAsker asker_;
    glm::dvec3 origin_;
    double voxel_;
    glm::dvec3 centre_{0.0};
    double distance_ = 0.0; ///< from its centre to the surface, voxels
    bool far_ = false;
    bool crowded_ = false; ///< too many to be examined
    std::vector<std::uint32_t> numbers_;
    std::vector<Near> near_;
    std::vector<double> squared_;
    std::vector<std::size_t> ones_; ///< triangles that represent similar ones
};

} // namespace burin
