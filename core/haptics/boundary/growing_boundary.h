// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/growing_field.h"
#include "core/haptics/boundary/pose_boundary.h"

#include <memory>
#include <vector>

namespace burin {

/// A GrowingField as a boundary of one session: the tool has the axis that the field was made for. Where the field is
/// not fine yet, its outline holds the tool, farther from the part than the part itself would. New tiles come into
/// force only when the loop is told so, between two ticks (HapticStep::takeTiles), so that a recorded session can be
/// replayed.
class GrowingBoundary final : public PoseBoundary {
public:
    using Tiles = std::vector<std::shared_ptr<const BrickField>>; ///< indexed by tile number; null: not available

    /// For a live session: tiles that are available come into force first, the nearest first; all of them at once if
    /// the field is complete.
    /// @param turn rotation from the setup frame to the field's frame
    GrowingBoundary(std::shared_ptr<GrowingField> field, const glm::dmat3& turn);
    /// For a replayed session: tiles come into force when the recorded changes say so, taken from `made`.
    GrowingBoundary(std::shared_ptr<GrowingField> field, const glm::dmat3& turn, Tiles made);

    PoseSample at(const ToolPose& pose, double enough) noexcept override;
    double errorBound() const noexcept override { return field_->errorBound(); }
    double spacing() const noexcept override { return field_->spacing(); }
    double overlap() const noexcept override { return 0.0; }
    double reach() const noexcept override { return 0.0; }
    std::optional<TileChange> nextChange(const ToolPose& tool) noexcept override;
    void apply(const TileChange& change) noexcept override;

private:
    const std::shared_ptr<GrowingField> field_;
    const TileLayout layout_;
    const glm::dmat3 turn_;
    const bool turns_;
    const Tiles made_;
    std::shared_ptr<TileFeed> feed_;
    std::vector<const BrickField*> inForce_; ///< by tile number; null: the outline is in force
    TileNews news_;                          ///< the newest tile reported by the feed
};

} // namespace burin
