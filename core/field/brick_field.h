// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace burin {

/// Samples of a tool's clearance over a box of tips: everywhere at the corners of bricks, and in fine bricks at the
/// corners of their cells. A fine brick stores all samples of its cells, so that a look-up reads no other brick.
struct BrickField {
    static constexpr int cells = 8; ///< of a brick, along each axis
    static constexpr int samplesAlong = cells + 1;
    static constexpr int samplesPerBrick = samplesAlong * samplesAlong * samplesAlong;
    static constexpr std::int32_t coarse = -1;

    Box tips;                        ///< mm
    double spacing = 1.0;            ///< of fine samples, mm
    double interpolationBound = 0.0; ///< mm, subtracted from every fine sample
    double quantum = 1.0;            ///< mm, one unit of a fine sample
    glm::ivec3 bricks{1};            ///< along x, y, z
    std::vector<std::int32_t> place; ///< per brick: index of its fine samples, or `coarse`
    std::vector<float> corners;      ///< (bricks + 1) along each axis: clearance, mm
    std::vector<float> coarseBound;  ///< per brick: how much too high interpolation between its corners may be, mm
    std::vector<std::int16_t> samples;
    std::vector<float> fineBound; ///< per fine brick: how much too high its values may be, mm

    double brickEdge() const noexcept { return spacing * cells; }
    std::size_t brickCount() const noexcept { return count(bricks); }
    std::size_t cornerCount() const noexcept { return count(bricks + 1); }
    std::size_t brickAt(const glm::ivec3& b) const noexcept { return at(b, bricks); }
    glm::ivec3 brickOf(std::size_t number) const noexcept {
        const auto nx = static_cast<std::size_t>(bricks.x), ny = static_cast<std::size_t>(bricks.y);
        return {static_cast<int>(number % nx), static_cast<int>(number / nx % ny), static_cast<int>(number / nx / ny)};
    }
    std::size_t cornerAt(const glm::ivec3& c) const noexcept { return at(c, bricks + 1); }
    static std::size_t sampleAt(const glm::ivec3& s) noexcept { return at(s, glm::ivec3(samplesAlong)); }
    glm::dvec3 brickLow(const glm::ivec3& b) const noexcept { return tips.low + glm::dvec3(b) * brickEdge(); }
    std::size_t memoryBytes() const noexcept {
        return place.capacity() * sizeof(std::int32_t) +
               (corners.capacity() + coarseBound.capacity() + fineBound.capacity()) * sizeof(float) +
               samples.capacity() * sizeof(std::int16_t);
    }

    /// Trilinear clearance and its gradient. A tip outside the box of tips gets those of the box's nearest point, and
    /// the sample is not fine; a coordinate that is not a number counts as the lowest. Any thread; no allocation.
    FieldSample sample(const glm::dvec3& tip) const noexcept;
    /// The same for a tip that lies in the box except for rounding.
    FieldSample sampleInside(const glm::dvec3& tip) const noexcept {
        return sample(glm::clamp(tip, tips.low, tips.high));
    }
    /// How much the clearance may be above the true one, mm.
    double bound(const glm::dvec3& tip) const noexcept;

private:
    static std::size_t count(const glm::ivec3& n) noexcept {
        return static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y) * static_cast<std::size_t>(n.z);
    }
    static std::size_t at(const glm::ivec3& i, const glm::ivec3& n) noexcept {
        return static_cast<std::size_t>(i.x) +
               static_cast<std::size_t>(n.x) *
                   (static_cast<std::size_t>(i.y) + static_cast<std::size_t>(n.y) * static_cast<std::size_t>(i.z));
    }
};

} // namespace burin
