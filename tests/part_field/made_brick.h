// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/part_field/part_field_layers.h"

namespace burin {

/// Cells of a brick: one word per layer, bit x + 8 y.
using CellMask = std::array<std::uint64_t, 8>;

/// A fine brick as computed by BrickMaker; the builder combines the bricks.
struct MadeBrick {
    FineBrick header;
    std::array<std::int8_t, CellGrid::samples> narrow{}; ///< residuals, unless they are wide
    std::vector<std::int16_t> wide;
    CellMask exactMask{};
    CellMask lookedMask{};                ///< cells that were examined for folds of the surface
    CellMask thinMask{};                  ///< cells near a gap or a wall that may lie between samples
    std::vector<std::uint32_t> cellLists; ///< per exact cell: where its list begins in `lists`
    std::vector<std::uint32_t> lists;
    float bound = 0.0F;           ///< mm
    float sampleBound = 0.0F;     ///< mm: of the samples only
    float kinkError = 0.0F;       ///< mm, not in the bound: additional error by kinks between wide facets
    int wideFacet = 0;            ///< voxels: width from which a facet counts as wide
    float least = 0.0F;           ///< mm
    std::uint32_t bandVoxels = 0; ///< its own samples (all but those on the upper faces) within the band
};

/// The value of a brick where its cells are trilinear, mm. @param place voxels from its lowest corner, 0 … 8
float distanceIn(const MadeBrick& made, const glm::vec3& place) noexcept;
/// Whether a point is in an exact cell.
bool isExactIn(const MadeBrick& made, const glm::vec3& place) noexcept;

/// The largest difference, mm, between the samples that two bricks share. @param axis direction from the first to the
/// second brick
float disagreement(const MadeBrick& first, const MadeBrick& second, int axis) noexcept;

} // namespace burin
