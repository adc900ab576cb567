// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/field/brick_field.h"
#include "core/field/field_builder.h"
#include "core/field/tip_asker.h"

#include <optional>

namespace burin {

/// Clearances at the corners of all bricks of a tool's field: asked of the part where the fine band may be near, and at
/// corners farther apart elsewhere, between which the others get a value that they have for certain.
class TipCorners {
public:
    TipCorners(const MeshDistance& part, const ToolFieldRequest& request, const FieldResolution& resolution,
               BrickField& field);

    /// Fills the field's corners and the bounds of its coarse bricks, too. Parallel, reported between the fractions.
    void sample(Progress& progress, double from, double to);

    /// By corner, mm, with their gradients.
    const std::vector<TipSample>& samples() const noexcept { return samples_; }
    /// Whether some tip in a brick may be in the band. @param asker  for the middle of a doubtful one
    bool mayHoldBand(const glm::ivec3& brick, TipAsker& asker) const;

    /// Largest clearance of a corner with which a brick of this edge may have the band in it, or say less than
    /// `FieldResolution::clear` when it is coarse, mm.
    static double nearEnough(const FieldResolution& resolution, double edge) noexcept;

private:
    struct Cube {
        glm::ivec3 low, high; ///< corners, in bricks
    };
    bool isAt(const glm::ivec3& corner, int step) const noexcept;
    void sampleAt(int step, int above, Progress& progress, double from, double to);
    std::optional<double> safeValue(const glm::ivec3& corner, int step) const noexcept;
    std::optional<double> safeValue(const glm::ivec3& corner, const Cube& cube) const noexcept;
    void boundCoarseBricks();

    const MeshDistance& part_;
    const ToolFieldRequest& request_;
    const FieldResolution resolution_;
    BrickField& field_;
    std::vector<TipSample> samples_;
};

} // namespace burin
