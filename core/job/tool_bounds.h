// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/growing_field.h"
#include "core/haptics/boundary/boundary_layers.h"
#include "core/haptics/boundary/growing_boundary.h"
#include "core/haptics/boundary/tool_boundaries.h"
#include "core/haptics/trace/session_trace.h"
#include "core/job/milling_context.h"
#include "core/machine/envelope.h"
#include "core/setup/axis_mode.h"
#include "core/setup/obstacle.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// A mesh that somebody keeps for longer than what gets it: the milling context's own part, as a rule.
inline std::shared_ptr<const MeshDistance> lent(const MeshDistance& mesh) {
    return {std::shared_ptr<void>(), &mesh};
}

/// What bounds a milling context's tool besides the part.
struct Surroundings {
    std::vector<Obstacle> obstacles; ///< layers 1, 2, …
    Envelope envelope;               ///< the layer after them, where it sets a limit
};

/// What stands around a milling context, and the travel of its machine. A travel bounds an upright tool alone: how a
/// three-axis machine's axes move a tilted one is not known.
Surroundings surroundingsOf(const MillingContext& milling, const TravelPlacement& placement, const AxisMode& axis);

/// One of the layers that bound a tool, for whoever shows and switches it.
struct BoundLayer {
    enum class Kind : std::uint8_t { part, fixture, keepOut, machineTravel };
    Kind kind = Kind::part;
    std::string name; ///< of the obstacle; empty for part and travel
    bool on = true;   ///< from the start
};

/// What bounds a tool on a milling context, made once in the background and used by any number of sessions: each gets
/// layers of its own. Immutable; shares what is large when it is copied; any thread.
class ToolBounds {
public:
    /// Of layers, the part's and the travel's among them.
    static constexpr std::size_t capacity = 64;

    /// The part alone, as a field of tips for the axis +Z that the caller keeps: it outlives the object and all its
    /// layers.
    static ToolBounds borrowing(const ClearanceField& part);
    /// The same; the field goes with the object.
    explicit ToolBounds(std::shared_ptr<const ClearanceField> part);

    /// The part is layer 0: a field of tips where the axis stands, the mesh itself where it is free. The milling
    /// context outlives what is made. Cost: that of `clearanceField`, none with a free axis; and of a search tree an
    /// obstacle.
    /// @param tool that the milling context has or is about to get
    /// Errors: cancelled, outOfMemory, those of checkObstacle, argumentInvalid (an axis that is not of unit length, too
    /// many obstacles).
    static Result<ToolBounds> build(const MillingContext& milling, const Tool& tool, const AxisMode& axis,
                                    const Surroundings& surroundings, double maximumAllowance, Progress& progress);

    /// The same, to mill with in a moment whatever the size: the part's field grows in the background, around the tool
    /// first, and holds the tool where it is not there yet. What is whole within some tenths of a second is awaited.
    /// A free axis has no field.
    /// @param part the milling context's mesh; shared by what is made @param limits of the field
    static Result<ToolBounds> grow(const MillingContext& milling, std::shared_ptr<const MeshDistance> part,
                                   const Tool& tool, const AxisMode& axis, const Surroundings& surroundings,
                                   double maximumAllowance, const GrowthLimits& limits, Progress& progress);
    /// As they grew while a trace was recorded whose `TracedSession::growth` says so: for a session that plays it
    /// (SessionRequest::replayed). Makes what the trace names, in the caller's thread. Errors: also traceInvalid (it
    /// names what this milling context does not have).
    static Result<ToolBounds> asGrown(const MillingContext& milling, const Tool& tool, const AxisMode& axis,
                                      const Surroundings& surroundings, const SessionTrace& trace, Progress& progress);

    /// Waits until the field has nothing left to do for the tool where it is; at once where none grows.
    /// @param progress gets the share of the field that is there. Errors: cancelled, outOfMemory (what is not there
    /// holds the tool for good).
    Result<void> waitUntilQuiet(Progress& progress) const;
    /// Makes all of the field, and keeps it. Errors: cancelled, outOfMemory.
    Result<void> finish(Progress& progress) const;
    /// Every tip is answered as the part itself is: the field is all there, or the axis free.
    bool complete() const { return !growing_ || growing_->complete(); }
    /// Of a field that grows, as it is now; 0 where none does.
    std::size_t memoryBytes() const { return growing_ ? growing_->memoryBytes() : 0; }
    /// How it grows, for the trace of a session; none where it does not.
    std::optional<TracedSession::Growth> growth() const;

    /// For one session; quick. Layers go on without the object.
    BoundaryLayers boundaryLayers() const;
    /// By their number.
    const std::vector<BoundLayer>& layers() const noexcept { return layers_; }
    const AxisMode& axis() const noexcept { return axis_; }         ///< that the layers were made for
    const Envelope& envelope() const noexcept { return envelope_; } ///< setup frame; without limits where none is on
    /// The part's clearance where the axis stands, over tips; null where it is free.
    const ClearanceField* field() const noexcept { return field_.get(); }

private:
    /// What a growing field is made of and seen through.
    struct Seen {
        std::shared_ptr<const MeshDistance> part;
        glm::dmat3 turn{1.0};
    };
    ToolBounds() = default;
    static Result<ToolBounds> withoutField(const MillingContext& milling, const Tool& tool, const AxisMode& axis,
                                           const Surroundings& surroundings);
    Result<void> lay(const MillingContext& milling, const Seen& seen, const Tool& tool, double maximumAllowance,
                     const GrowthLimits& limits, Progress& progress);
    std::unique_ptr<PoseBoundary> partBoundary() const;

    AxisMode axis_;
    std::shared_ptr<const ClearanceField> field_;
    std::shared_ptr<GrowingField> growing_; ///< null: the field is all there
    glm::dmat3 turn_{1.0};                  ///< from the setup frame to the growing field's
    double maximumAllowance_ = 0.0;         ///< mm, of the growing field
    std::optional<GrowingBoundary::Tiles> replayed_;
    const MeshDistance* mesh_ = nullptr; ///< the milling context's; null: the part's field alone
    double voxel_ = 0.0;                 ///< mm
    Tool tool_;
    std::vector<ObstacleSolid> obstacles_;
    Envelope envelope_;
    std::vector<BoundLayer> layers_;
};

/// What bounds the milling context's own tool, for HapticStep: the layers of its ToolBounds.
Result<BoundaryLayers> boundaryLayers(const MillingContext& milling, const AxisMode& axis,
                                      const Surroundings& surroundings, double maximumAllowance, Progress& progress);

} // namespace burin
