// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/growing_field.h"
#include "core/haptics/boundary/boundary_layers.h"
#include "core/haptics/boundary/growing_boundary.h"
#include "core/haptics/boundary/tool_boundaries.h"
#include "core/haptics/trace/session_trace.h"
#include "core/job/milling_context.h"
#include "core/job/touched_stock.h"
#include "core/machine/envelope.h"
#include "core/setup/axis_mode.h"
#include "core/setup/obstacle.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// Returns a non-owning pointer to a mesh that outlives the receiver: usually the milling context's own part.
inline std::shared_ptr<const MeshDistance> lent(const MeshDistance& mesh) {
    return {std::shared_ptr<void>(), &mesh};
}

/// The limits of a milling context's tool other than the part.
struct Surroundings {
    std::vector<Obstacle> obstacles; ///< layers 1, 2, …
    Envelope envelope;               ///< the layer after them, if it sets a limit
};

/// Returns the fixtures and keep-out volumes of a milling context, and the travel of its machine. Travel limits apply
/// only to an upright tool: how the axes of a three-axis machine move a tilted one is not known.
Surroundings surroundingsOf(const MillingContext& milling, const TravelPlacement& placement, const AxisMode& axis);

/// One of the layers that bound a tool, for displaying and switching it.
struct BoundLayer {
    enum class Kind : std::uint8_t { part, fixture, keepOut, machineTravel, stock };
    Kind kind = Kind::part;
    std::string name; ///< of the obstacle; empty for part, travel and stock
    bool on = true;   ///< initially
};

/// The limits of a tool on a milling context, made once in the background and used by any number of sessions, each of
/// which gets its own layers. Immutable and thread-safe; copies share large data.
class ToolBounds {
public:
    /// Largest number of layers, including those of the part, the travel and the stock (StockLayer).
    static constexpr std::size_t capacity = 64;

    /// Bounds by the part alone, given as a field over tips for the axis +Z. The caller keeps the field: it must
    /// outlive the object and all its layers.
    static ToolBounds borrowing(const ClearanceField& part);
    /// The same; the object shares ownership of the field.
    explicit ToolBounds(std::shared_ptr<const ClearanceField> part);

    /// Makes the bounds. The part is layer 0: a field over tips for a fixed axis, the mesh itself for a free one. The
    /// milling context must outlive the result. Cost: that of `clearanceField`, none with a free axis; and of one
    /// search tree per obstacle.
    /// @param tool that the milling context has or is about to get
    /// Errors: cancelled, outOfMemory, those of checkObstacle, argumentInvalid (an axis that is not of unit length, too
    /// many obstacles), notSupported (a tool that doesn't turn or is hollow, unless it stays upright).
    static Result<ToolBounds> build(const MillingContext& milling, const Tool& tool, const AxisMode& axis,
                                    const Surroundings& surroundings, double maximumAllowance, Progress& progress);

    /// The same, but ready for milling almost immediately for any size: the part's field grows in the background,
    /// around the tool first, and stops the tool where it is not computed yet. Waits for the complete field if that
    /// takes only some tenths of a second. A free axis has no field.
    /// @param part the milling context's mesh; shared with the result @param limits of the field
    static Result<ToolBounds> grow(const MillingContext& milling, std::shared_ptr<const MeshDistance> part,
                                   const Tool& tool, const AxisMode& axis, const Surroundings& surroundings,
                                   double maximumAllowance, const GrowthLimits& limits, Progress& progress);
    /// The bounds as they grew while a trace was recorded, according to its `TracedSession::growth`: for a session that
    /// plays it (SessionRequest::replayed). Computes the tiles that the trace names, on the caller's thread. Errors:
    /// also traceInvalid (it names something that this milling context does not have).
    static Result<ToolBounds> asGrown(const MillingContext& milling, const Tool& tool, const AxisMode& axis,
                                      const Surroundings& surroundings, const SessionTrace& trace, Progress& progress);

    /// Adds the stock before milling as the last layer, off until a session switches it on: for touching it off with a
    /// tool that doesn't cut. Nothing is added beyond `capacity`, or a second time.
    void addStock(std::shared_ptr<const TouchableStock> stock);
    /// The stock that was added; null: none.
    const std::shared_ptr<const TouchableStock>& stock() const noexcept { return stock_; }

    /// Blocks until the field has nothing left to compute for the tool's present position; returns immediately if no
    /// field grows.
    /// @param progress gets the computed share of the field. Errors: cancelled, outOfMemory (the missing parts then
    /// stop the tool permanently).
    Result<void> waitUntilQuiet(Progress& progress) const;
    /// Computes the entire field, and keeps it. Errors: cancelled, outOfMemory.
    Result<void> finish(Progress& progress) const;
    /// Whether every tip is answered by the part itself: the field is complete, or the axis is free.
    bool complete() const { return !growing_ || growing_->complete(); }
    /// Returns the present memory of a growing field; 0 if none grows.
    std::size_t memoryBytes() const { return growing_ ? growing_->memoryBytes() : 0; }
    /// Returns how the field grows, for the trace of a session; empty if it does not grow.
    std::optional<TracedSession::Growth> growth() const;

    /// Returns layers for one session; fast. The layers do not depend on the lifetime of the object.
    BoundaryLayers boundaryLayers() const;
    /// Returns the layers, by their number.
    const std::vector<BoundLayer>& layers() const noexcept { return layers_; }
    const AxisMode& axis() const noexcept { return axis_; }         ///< for which the layers were made
    const Envelope& envelope() const noexcept { return envelope_; } ///< setup frame; without limits if none is on
    /// Returns the part's clearance field over tips for a fixed axis; null for a free axis.
    const ClearanceField* field() const noexcept { return field_.get(); }

private:
    /// The mesh of a growing field, and the rotation into its frame.
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
    std::shared_ptr<GrowingField> growing_; ///< null: the field is complete
    glm::dmat3 turn_{1.0};                  ///< from the setup frame to the growing field's
    double maximumAllowance_ = 0.0;         ///< mm, of the growing field
    std::optional<GrowingBoundary::Tiles> replayed_;
    const MeshDistance* mesh_ = nullptr; ///< of the milling context; null: only the part's field
    double voxel_ = 0.0;                 ///< mm
    Tool tool_;
    std::vector<ObstacleSolid> obstacles_;
    Envelope envelope_;
    std::shared_ptr<const TouchableStock> stock_; ///< null: it is no layer
    std::vector<BoundLayer> layers_;
};

/// Returns the layers of the ToolBounds of the milling context's own tool, for HapticStep.
Result<BoundaryLayers> boundaryLayers(const MillingContext& milling, const AxisMode& axis,
                                      const Surroundings& surroundings, double maximumAllowance, Progress& progress);

} // namespace burin
