// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/axis_mode.h"
#include "core/haptics/boundary_layers.h"
#include "core/haptics/tool_boundaries.h"
#include "core/machine/envelope.h"
#include "core/project/bench.h"
#include "core/setup/obstacle.h"

#include <memory>
#include <string>
#include <vector>

namespace burin {

/// What bounds a bench's tool besides the part.
struct Surroundings {
    std::vector<Obstacle> obstacles; ///< layers 1, 2, …
    Envelope envelope;               ///< the layer after them, where it sets a limit
};

/// What stands around a bench, and the travel of its machine. A travel bounds an upright tool alone: how a three-axis
/// machine's axes move a tilted one is not known.
Surroundings surroundingsOf(const Bench& bench, const TravelPlacement& placement, const AxisMode& axis);

/// One of the layers that bound a tool, for whoever shows and switches it.
struct BoundLayer {
    enum class Kind : std::uint8_t { part, fixture, keepOut, machineTravel };
    Kind kind = Kind::part;
    std::string name; ///< of the obstacle; empty for part and travel
    bool on = true;   ///< from the start
};

/// What bounds a tool on a bench, made once in the background and used by any number of sessions: each gets layers of
/// its own. Immutable; shares what is large when it is copied; any thread.
class ToolBounds {
public:
    /// Of layers, the part's and the travel's among them.
    static constexpr std::size_t capacity = 64;

    /// The part alone, as a field of tips for the axis +Z. It outlives the object and all its layers.
    ToolBounds(const ClearanceField& part); // NOLINT(google-explicit-constructor): a field is bounds enough
    /// The same; the field goes with the object.
    explicit ToolBounds(std::shared_ptr<const ClearanceField> part);

    /// The part is layer 0: a field of tips where the axis stands, the mesh itself where it is free. The bench outlives
    /// what is made. Cost: that of `clearanceField`, none with a free axis; and of a search tree an obstacle.
    /// @param tool that the bench has or is about to get
    /// Errors: cancelled, outOfMemory, those of checkObstacle, argumentInvalid (an axis that is not of unit length, too
    /// many obstacles).
    static Result<ToolBounds> build(const Bench& bench, const Tool& tool, const AxisMode& axis,
                                    const Surroundings& surroundings, double maximumAllowance, Progress& progress);

    /// For one session; quick. Layers go on without the object.
    BoundaryLayers boundaryLayers() const;
    /// By their number.
    const std::vector<BoundLayer>& layers() const noexcept { return layers_; }
    const AxisMode& axis() const noexcept { return axis_; }
    const Envelope& envelope() const noexcept { return envelope_; }
    /// The part's clearance where the axis stands, over tips; null where it is free.
    const ClearanceField* field() const noexcept { return field_.get(); }

private:
    ToolBounds() = default;

    AxisMode axis_;
    std::shared_ptr<const ClearanceField> field_;
    const MeshDistance* mesh_ = nullptr; ///< the bench's; null: the part's field alone
    double voxel_ = 0.0;                 ///< mm
    Tool tool_;
    std::vector<ObstacleSolid> obstacles_;
    Envelope envelope_;
    std::vector<BoundLayer> layers_;
};

/// What bounds the bench's own tool, for HapticStep: the layers of its ToolBounds.
Result<BoundaryLayers> boundaryLayers(const Bench& bench, const AxisMode& axis, const Surroundings& surroundings,
                                      double maximumAllowance, Progress& progress);

} // namespace burin
