// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/field/brick_field.h"
#include "core/field/field_builder.h"
#include "core/field/tip_asker.h"

#include <optional>

namespace burin {

/// Clearances at the corners of all bricks of a tool's field: evaluated with the part where the fine band may be near,
/// and elsewhere at corners farther apart, between which the other corners get a lower bound.
class TipCorners {
public:
    TipCorners(const MeshDistance& part, const ToolFieldRequest& request, const FieldResolution& resolution,
               BrickField& field);

    /// Also fills the field's corners and the bounds of its coarse bricks. Parallel; reports progress between the
    /// fractions.
    void sample(Progress& progress, double from, double to);

    /// By corner, mm, with their gradients.
    const std::vector<TipSample>& samples() const noexcept { return samples_; }
    /// Whether some tip in a brick may be in the band. @param asker  evaluates the middle of a doubtful brick
    bool mayHoldBand(const glm::ivec3& brick, TipAsker& asker) const;

    /// Largest clearance at a corner, mm, for which a brick of this edge may contain the band, or return less than
    /// `FieldResolution::clear` when it is coarse.
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
