// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/brick_field.h"
#include "core/field/field_builder.h"
#include "core/field/part_sample.h"

#include <optional>

namespace burin {

inline constexpr double farthestClearance = 1e6; ///< mm: what an empty part answers

/// Clearance and its gradient with the tip at a place.
struct ClearanceSample {
    double value = 0.0;       ///< mm
    glm::dvec3 gradient{0.0}; ///< not a number where the clearance was not found within the limit
};

/// @param within mm; more is answered as this  @param tolerance mm, by which it may be too great
ClearanceSample clearanceAt(const MeshDistance& part, const ToolFieldRequest& request, const glm::dvec3& tip,
                            double within, double tolerance = 1e-8);

/// Fills the fine bricks of a field. Where the corners of a brick say that the clearance is smooth, and its middle
/// agrees, its samples follow from them by cubics (Hermite). Elsewhere every second sample along each axis is asked of
/// the mesh, with its gradient; what lies between follows from those two in the same way, or is asked of the mesh.
class BrickSampler {
public:
    /// @param fine numbers of the fine bricks, in the order of their samples
    /// @param corners  of the bricks, as the field's, with their gradients
    BrickSampler(const MeshDistance& part, const ToolFieldRequest& request, const FieldResolution& resolution,
                 BrickField& field, const std::vector<std::uint32_t>& fine, const std::vector<PartSample>& corners);

    /// Whether a brick's corners tell all its samples. Any thread, each brick once, before the others.
    void look(std::size_t order);

    /// The even samples that a brick owns: all but those on its upper faces. Any thread, each brick once.
    void sampleEven(std::size_t order);
    /// All of a brick's samples. Any thread, each brick once, when all bricks have their even ones.
    void fill(std::size_t order);

private:
    static constexpr int evens = BrickField::cells / 2; ///< owned, along an axis
    static constexpr int evensAlong = evens + 1;

    struct Even {
        float value = 0.0F;
        glm::vec3 gradient{0.0F};
    };
    using Evens = std::array<ClearanceSample, evensAlong * evensAlong * evensAlong>;

    ClearanceSample ask(const glm::dvec3& tip, double within) const;
    glm::dvec3 place(std::size_t order, const glm::ivec3& sample) const noexcept;
    Evens gather(std::size_t order) const;
    std::optional<double> between(const Evens& all, const glm::ivec3& sample) const noexcept;
    std::int16_t packed(double value) const noexcept;
    bool cornersAgree(std::size_t order, SampleGrid& nine) const;
    void fillSmooth(std::size_t order);

    const MeshDistance& part_;
    const ToolFieldRequest& request_;
    const FieldResolution resolution_;
    BrickField& field_;
    const std::vector<std::uint32_t>& fine_;
    const std::vector<PartSample>& corners_;
    std::vector<std::uint8_t> smooth_; ///< 1: the corners do
    std::vector<Even> even_;
};

} // namespace burin
