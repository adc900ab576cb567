// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/sample_grid.h"
#include "tests/part_field/part_asker.h"
#include "tests/part_field/part_field_layers.h"

#include <span>

namespace burin {

/// The triangles of a mesh that are or could be nearest to some point of a cell, a cube of one voxel. One thread each.
class CellTriangles {
public:
    static constexpr std::size_t most = 64; ///< that an exact cell may name

    CellTriangles(const MeshDistance& part, const glm::dvec3& origin, double voxel) noexcept
        : part_(part), asker_(part, origin, voxel), origin_(origin), voxel_(voxel) {}

    /// @param centre  the cell's middle, voxels from the origin
    void find(const glm::dvec3& centre);
    /// The same; where the surface folds, those only that may be nearest in an eighth of the cell.
    /// @return whether it folds, as `isFolded` says
    bool findFold(const glm::dvec3& centre, float cosine);

    /// What a fold may move the distance by, voxels, where nobody looked for one: in cells that are far from the
    /// surface and in those with too many triangles around them (the square of its half width over twice the distance).
    /// 0 where `findFold` did look.
    float unseen() const noexcept;
    /// Whether the surface folds within two and a half voxels, so that a gap or a wall may lie between samples.
    /// @param cosine  of the most that the normals of two triangles may differ
    bool isFolded(float cosine);
    /// What was found: numbers, rising; empty if those are more than `most`.
    std::span<const std::uint32_t> numbers();

private:
    struct Near {
        std::uint32_t number = 0;
        bool wanted = false;
        glm::vec3 normal{0.0F}; ///< zero without an area
        glm::vec3 place{0.0F};  ///< nearest to the cell's middle, voxels from there
        double away = 0.0;      ///< how far that is, mm
    };

    void gather(const glm::dvec3& centre);
    void keepInEighths();
    static bool fold(const Near& a, const Near& b, float cosine) noexcept;

    const MeshDistance& part_;
    PartAsker asker_;
    glm::dvec3 origin_;
    double voxel_;
    glm::dvec3 centre_{0.0};
    double distance_ = 0.0; ///< from its middle to the surface, voxels
    bool far_ = false;
    bool crowded_ = false; ///< so many that they are not looked at
    std::vector<std::uint32_t> numbers_;
    std::vector<Near> near_;
    std::vector<double> squared_;
    std::vector<std::size_t> ones_; ///< that stand for others
};

} // namespace burin
