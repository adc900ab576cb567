// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/tool_bounds.h"

#include "core/geometry/frame_along.h"
#include "core/geometry/upright.h"
#include "core/haptics/boundary/fixed_axis_boundary.h"
#include "core/haptics/boundary/mesh_boundary.h"
#include "core/haptics/boundary/turned_field.h"

#include <limits>
#include <utility>

namespace burin {

namespace {

using Field = std::shared_ptr<const ClearanceField>;

Result<Field> fieldFor(const MillingContext& milling, const Tool& tool, const glm::dvec3& axis, double maximumAllowance,
                       Progress& progress) {
    if (axis == uprightAxis || milling.partModel->bodies.empty()) {
        Result<std::unique_ptr<const ClearanceField>> field = clearanceField(milling, tool, maximumAllowance, progress);
        if (!field) return std::move(field).error();
        return Field(std::move(*field));
    }
    const ToolFieldRequest request{pieces(tool.cutter), milling.tipRegion(tool), milling.setup.voxel, maximumAllowance};
    Result<TurnedField> field = TurnedField::build(milling.part, axis, request, progress);
    if (!field) return std::move(field).error();
    return Field(std::make_shared<const TurnedField>(std::move(*field)));
}

/// A field of a part seen along an axis, queried in the setup frame.
class SetupView final : public ClearanceField {
public:
    SetupView(Field seen, const glm::dmat3& turn) noexcept : seen_(std::move(seen)), turn_(turn) {}
    FieldSample at(const glm::dvec3& tip) const noexcept override {
        FieldSample sample = seen_->at(turn_ * tip);
        sample.gradient = sample.gradient * turn_; // multiplies by the transposed rotation, the inverse
        return sample;
    }
    double errorBound() const noexcept override { return seen_->errorBound(); }
    double errorBoundAt(const glm::dvec3& tip) const noexcept override { return seen_->errorBoundAt(turn_ * tip); }
    double spacing() const noexcept override { return seen_->spacing(); }

private:
    Field seen_;
    glm::dmat3 turn_;
};

Result<void> checkObstacles(const std::vector<Obstacle>& obstacles) {
    constexpr std::size_t most = ToolBounds::capacity - 3;
    if (obstacles.size() > most)
        return Error{ErrorCode::argumentInvalid, "obstacles", std::to_string(obstacles.size()),
                     "0 to " + std::to_string(most)};
    for (const Obstacle& obstacle : obstacles)
        if (Result<void> usable = checkObstacle(obstacle); !usable) return usable;
    return {};
}

bool limits(const Envelope& envelope) {
    return !envelope.tips.empty() || !envelope.tools.empty();
}

std::vector<BoundLayer> namesOf(const Surroundings& surroundings) {
    using Kind = BoundLayer::Kind;
    std::vector<BoundLayer> layers{{Kind::part, {}, true}};
    for (const Obstacle& obstacle : surroundings.obstacles)
        layers.push_back(
            {obstacle.kind == ObstacleKind::fixture ? Kind::fixture : Kind::keepOut, obstacle.name, obstacle.on});
    if (limits(surroundings.envelope)) layers.push_back({Kind::machineTravel, {}, true});
    return layers;
}

} // namespace

Surroundings surroundingsOf(const MillingContext& milling, const TravelPlacement& placement, const AxisMode& axis) {
    Surroundings surroundings;
    surroundings.obstacles = milling.surroundings();
    if (!axis.free && axis.direction == uprightAxis)
        surroundings.envelope =
            travelEnvelope(milling.machine, placement, milling.setup.workOffset, topOf(milling.setup));
    return surroundings;
}

ToolBounds ToolBounds::borrowing(const ClearanceField& part) {
    return ToolBounds(Field(std::shared_ptr<void>(), &part));
}

ToolBounds::ToolBounds(std::shared_ptr<const ClearanceField> part) : field_(std::move(part)), layers_(namesOf({})) {}

Result<ToolBounds> ToolBounds::withoutField(const MillingContext& milling, const Tool& tool, const AxisMode& axis,
                                            const Surroundings& surroundings) {
    if (!axis.free && !(std::abs(glm::length(axis.direction) - 1.0) < 1e-6))
        return Error{ErrorCode::argumentInvalid, "axis", {}, "a vector of unit length"};
    if (axis.free || !isUpright(axis.direction))
        if (Result<void> tilts = checkTilts(tool.cutter); !tilts) return std::move(tilts).error();
    if (Result<void> usable = checkObstacles(surroundings.obstacles); !usable) return std::move(usable).error();
    ToolBounds bounds;
    bounds.axis_ = axis;
    bounds.mesh_ = &milling.part;
    bounds.voxel_ = milling.setup.voxel;
    bounds.tool_ = tool;
    bounds.obstacles_ = solidsOf(surroundings.obstacles);
    bounds.envelope_ = surroundings.envelope;
    bounds.layers_ = namesOf(surroundings);
    return bounds;
}

Result<ToolBounds> ToolBounds::build(const MillingContext& milling, const Tool& tool, const AxisMode& axis,
                                     const Surroundings& surroundings, double maximumAllowance, Progress& progress) {
    Result<ToolBounds> bounds = withoutField(milling, tool, axis, surroundings);
    if (!bounds || axis.free) return bounds;
    Result<Field> field = fieldFor(milling, tool, axis.direction, maximumAllowance, progress);
    if (!field) return std::move(field).error();
    bounds->field_ = std::move(*field);
    return bounds;
}

Result<void> ToolBounds::lay(const MillingContext& milling, const Seen& seen, const Tool& tool, double maximumAllowance,
                             const GrowthLimits& limits, Progress& progress) {
    const bool upright = seen.turn == glm::dmat3(1.0);
    const Box tips = milling.tipRegion(tool);
    const ToolFieldRequest request{pieces(tool.cutter), upright ? tips : boxAround(tips, seen.turn),
                                   milling.setup.voxel, maximumAllowance};
    const auto part = upright ? seen.part : std::make_shared<const MeshDistance>(turnedPart(*seen.part, seen.turn));
    Result<std::shared_ptr<GrowingField>> laid = GrowingField::lay(part, request, limits, progress);
    if (!laid) return std::move(laid).error();
    growing_ = std::move(*laid);
    turn_ = seen.turn;
    maximumAllowance_ = maximumAllowance;
    field_ = upright ? Field(growing_) : Field(std::make_shared<const SetupView>(growing_, turn_));
    return {};
}

Result<ToolBounds> ToolBounds::grow(const MillingContext& milling, std::shared_ptr<const MeshDistance> part,
                                    const Tool& tool, const AxisMode& axis, const Surroundings& surroundings,
                                    double maximumAllowance, const GrowthLimits& limits, Progress& progress) {
    // A part without bodies has no field that could grow.
    if (axis.free || milling.partModel->bodies.empty())
        return build(milling, tool, axis, surroundings, maximumAllowance, progress);
    Result<ToolBounds> bounds = withoutField(milling, tool, axis, surroundings);
    if (!bounds) return bounds;
    const Seen seen{std::move(part), axis.direction == uprightAxis ? glm::dmat3(1.0) : frameAlong(axis.direction)};
    if (Result<void> laid = bounds->lay(milling, seen, tool, maximumAllowance, limits, progress); !laid)
        return std::move(laid).error();
    constexpr double patience = 0.3; // s
    const glm::dvec3 centre = milling.setup.stock.centre();
    bounds->growing_->grow(bounds->turn_ * glm::dvec3(centre.x, centre.y, milling.setup.stock.high.z));
    static_cast<void>(bounds->growing_->waitUntilQuiet(progress, patience));
    return bounds;
}

Result<ToolBounds> ToolBounds::asGrown(const MillingContext& milling, const Tool& tool, const AxisMode& axis,
                                       const Surroundings& surroundings, const SessionTrace& trace,
                                       Progress& progress) {
    const TracedSession::Growth growth = trace.began->growth.value();
    Result<ToolBounds> bounds = withoutField(milling, tool, axis, surroundings);
    if (!bounds) return bounds;
    const Seen seen{lent(milling.part), axis.direction == uprightAxis ? glm::dmat3(1.0) : frameAlong(axis.direction)};
    if (Result<void> laid = bounds->lay(milling, seen, tool, growth.maximumAllowance, {}, progress); !laid)
        return std::move(laid).error();
    if (growth.whole) {
        if (Result<void> made = bounds->finish(progress); !made) return std::move(made).error();
        return bounds;
    }
    GrowingBoundary::Tiles tiles(bounds->growing_->layout().count());
    for (const TimedChange& timed : trace.changes) {
        const auto* const change = std::get_if<TileChange>(&timed.change);
        if (change == nullptr || !change->there) continue;
        if (change->tile >= tiles.size())
            return Error{ErrorCode::traceInvalid, "trace", "tile " + std::to_string(change->tile),
                         "the boundary that this project's tool has is made of fewer"};
        if (tiles[change->tile]) continue;
        Result<std::shared_ptr<const BrickField>> tile = bounds->growing_->tile(change->tile, progress);
        if (!tile) return std::move(tile).error();
        tiles[change->tile] = std::move(*tile);
    }
    bounds->replayed_ = std::move(tiles);
    return bounds;
}

void ToolBounds::addStock(std::shared_ptr<const TouchableStock> stock) {
    if (!stock || stock_ || layers_.size() >= capacity) return;
    stock_ = std::move(stock);
    layers_.push_back({BoundLayer::Kind::stock, {}, false});
}

Result<void> ToolBounds::waitUntilQuiet(Progress& progress) const {
    if (!growing_) return {};
    if (!growing_->waitUntilQuiet(progress, std::numeric_limits<double>::infinity()))
        return Error{ErrorCode::cancelled, "boundary field of a tool", {}, {}};
    if (const std::optional<Error> failure = growing_->failure()) return *failure;
    return {};
}

Result<void> ToolBounds::finish(Progress& progress) const {
    return growing_ ? growing_->finish(progress) : Result<void>{};
}

std::optional<TracedSession::Growth> ToolBounds::growth() const {
    if (!growing_) return std::nullopt;
    return TracedSession::Growth{maximumAllowance_, growing_->whole()};
}

std::unique_ptr<PoseBoundary> ToolBounds::partBoundary() const {
    if (replayed_) return std::make_unique<GrowingBoundary>(growing_, turn_, *replayed_);
    if (growing_) return std::make_unique<GrowingBoundary>(growing_, turn_);
    if (field_) return std::make_unique<FixedAxisBoundary>(field_);
    return std::make_unique<MeshBoundary>(lent(*mesh_), pieces(tool_.cutter), voxel_);
}

BoundaryLayers ToolBounds::boundaryLayers() const {
    BoundaryLayers layers(partBoundary());
    addLayers(layers, std::span<const ObstacleSolid>(obstacles_), envelope_, tool_, voxel_);
    if (stock_) layers.add(std::make_unique<MeshBoundary>(stock_->surface(), pieces(tool_.cutter), voxel_), false);
    return layers;
}

Result<BoundaryLayers> boundaryLayers(const MillingContext& milling, const AxisMode& axis,
                                      const Surroundings& surroundings, double maximumAllowance, Progress& progress) {
    const Result<ToolBounds> bounds =
        ToolBounds::build(milling, milling.tool, axis, surroundings, maximumAllowance, progress);
    if (!bounds) return bounds.error();
    return bounds->boundaryLayers();
}

} // namespace burin
